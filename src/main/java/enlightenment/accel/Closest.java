package enlightenment.accel;

import enlightenment.geometry.*;

public final class Closest {
    private double t;
    private int id;

    public void reset(double limit) {
        t = limit;
        id = -1;
    }

    public void offer(Ray ray, Primitive p, int i) {
        double s = p.nearest(ray, t);
        if (s < t) {
            t = s;
            id = i;
        }
    }

    public double t() {
        return t;
    }

    public int id() {
        return id;
    }
}

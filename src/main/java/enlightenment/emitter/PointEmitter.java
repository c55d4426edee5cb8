package enlightenment.emitter;

import enlightenment.math.Vec3;

/** A light without extent. */
public record PointEmitter(Vec3 position) implements Emitter {
    @Override
    public Vec3 ballCenter() {
        return position;
    }

    @Override
    public double ballRadius() {
        return 0;
    }

    @Override
    public boolean isDelta() {
        return true;
    }

    @Override
    public boolean surrounds(EmitterView view) {
        return false;
    }

    @Override
    public boolean isBelow(EmitterView view, double nx, double ny, double nz) {
        return cosine(view, nx, ny, nz) <= 0;
    }

    private static double cosine(EmitterView view, double nx, double ny, double nz) {
        return nx * view.cone.wx + ny * view.cone.wy + nz * view.cone.wz;
    }

    @Override
    public void sample(EmitterView view, double u, double v) {
        view.set(view.cone.wx, view.cone.wy, view.cone.wz, view.cone.distance);
    }

    @Override
    public double pdf(EmitterView view) {
        return view.length > 0 ? 1 : 0;
    }

    @Override
    public double pdf(EmitterView view, double x, double y, double z) {
        return 0;
    }

    @Override
    public double meanCosine(EmitterView view, double nx, double ny, double nz) {
        double cosine = cosine(view, nx, ny, nz);
        return cosine >= 0 ? cosine : Double.NaN;
    }

    @Override
    public void prepareByCosine(EmitterView view, double nx, double ny, double nz) {}

    @Override
    public void sampleByCosine(EmitterView view, double u, double v) {
        sample(view, u, v);
    }

    @Override
    public void sampleDisk(EmitterView view, double p, double q) {
        sample(view, p, q);
    }
}

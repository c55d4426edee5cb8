package enlightenment.emitter;

import enlightenment.math.Vec3;

/** A point light of classic shading. */
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
        return Math.max(nx * view.cone.wx + ny * view.cone.wy + nz * view.cone.wz, 0);
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

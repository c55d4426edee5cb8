package enlightenment.emitter;

import enlightenment.math.Vec3;
import enlightenment.sampling.Warp;

/**
 * A ball that emits outwards, sampled uniformly over the solid angle that it subtends, or by the cosine at the receiver where all of it is
 * above the horizon. From inside there are no samples: every direction hits it, so that BSDF samples find it as well.
 */
public final class SphereLight implements AreaLight {
    private static final Vec3 NOT_FLAT = Vec3.ZERO;

    private final SphereEmitter ball;
    private final Vec3 center;
    private final double x;
    private final double y;
    private final double z;
    private final double radius;

    /** Makes a ball. */
    public SphereLight(Vec3 center, double radius) {
        this.center = center;
        this.radius = radius;
        x = center.x();
        y = center.y();
        z = center.z();
        ball = new SphereEmitter(center, radius);
    }

    @Override
    public void aim(LightSample s, double px, double py, double pz) {
        s.aim(x, y, z, radius, px, py, pz);
    }

    @Override
    public void sample(LightSample s, double u, double v) {
        if (s.cone.inside) {
            s.absent();
            return;
        }
        ball.sample(s, u, v);
        s.cosine = s.half / radius;
        s.pdf = density(s);
    }

    private static double density(LightSample s) {
        double density = 1 / (2 * Math.PI * s.cone.oneMinusCosine());
        return density <= Double.MAX_VALUE ? density : 0;
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return s.cone.inside ? 0 : density(s);
    }

    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        return s.cone.inside ? Double.NaN : SphereIrradiance.of(s.cone, nx, ny, nz);
    }

    @Override
    public boolean hasClosedForm() {
        return true;
    }

    @Override
    public boolean samplesByCosine(LightSample s, double nx, double ny, double nz) {
        return !s.cone.inside && nx * s.cone.wx + ny * s.cone.wy + nz * s.cone.wz >= s.cone.sine;
    }

    /** Samples direction and distance by the cosine, and nothing else of the sample. Only where {@link #samplesByCosine} allows it. */
    public void directByCosine(LightSample s, double nx, double ny, double nz, double u, double v) {
        ball.prepareByCosine(s, nx, ny, nz);
        ball.sampleByCosine(s, u, v);
    }

    @Override
    public void sampleByCosine(LightSample s, double nx, double ny, double nz, double u, double v) {
        if (!samplesByCosine(s, nx, ny, nz)) {
            sample(s, u, v);
            return;
        }
        directByCosine(s, nx, ny, nz, u, v);
        s.cosine = s.half / radius;
        double density = (s.dx * nx + s.dy * ny + s.dz * nz) / SphereIrradiance.of(s.cone, nx, ny, nz);
        s.pdf = density > 0 && density <= Double.MAX_VALUE ? density : 0;
    }

    @Override
    public double area() {
        return 4 * Math.PI * radius * radius;
    }

    @Override
    public boolean isTwoSided() {
        return false;
    }

    /** Maps the disk to the ball by Lambert's equal-area projection. */
    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        Warp.toDisk(u, v, point.disk);
        double q = point.disk[2];
        double spread = 2 * Math.sqrt(Math.max(1 - q, 0));
        point.setNormal(point.disk[0] * spread, point.disk[1] * spread, 1 - 2 * q);
        point.set(Math.fma(radius, point.nx, x), Math.fma(radius, point.ny, y), Math.fma(radius, point.nz, z));
    }

    @Override
    public Vec3 ballCenter() {
        return center;
    }

    @Override
    public double ballRadius() {
        return radius;
    }

    @Override
    public Vec3 flatNormal() {
        return NOT_FLAT;
    }

    @Override
    public double[] parameters() {
        return new double[] {x, y, z, radius};
    }
}

package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.sampling.Warp;

/** A flat disk, sampled uniformly over its area. */
public final class DiskLight extends FlatLight {
    private final Vec3 center;
    private final double radius;
    private final Basis basis = new Basis();

    /** Makes a disk that emits from its front, or from both sides. */
    public DiskLight(Vec3 center, Vec3 normal, double radius, boolean twoSided) {
        this(center, normal, radius, LightSides.of(twoSided));
    }

    /**
     * Makes a disk.
     *
     * @param normal of length 1, on its front
     * @param sides that emit
     */
    public DiskLight(Vec3 center, Vec3 normal, double radius, LightSides sides) {
        super(center, normal, Math.PI * radius * radius, sides, center, radius * (1 + Scale.gamma(8)));
        this.center = center;
        this.radius = radius;
        basis.around(normal.x(), normal.y(), normal.z());
    }

    @Override
    public void sample(LightSample s, double u, double v) {
        if (!faces(s)) {
            s.absent();
            return;
        }
        Warp.toDisk(u, v, s.disk);
        double p = radius * s.disk[0];
        double q = radius * s.disk[1];
        choose(
                s,
                Math.fma(p, basis.ax, Math.fma(q, basis.bx, center.x() - s.cone.x)),
                Math.fma(p, basis.ay, Math.fma(q, basis.by, center.y() - s.cone.y)),
                Math.fma(p, basis.az, Math.fma(q, basis.bz, center.z() - s.cone.z)));
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return density(distance, cosine);
    }

    /** 0 if the receiver is on a side that does not emit, or the disk below its horizon; NaN otherwise. */
    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        if (!faces(s)) {
            return 0;
        }
        double along = nx * normal.x() + ny * normal.y() + nz * normal.z();
        double highest = nx * (center.x() - s.cone.x)
                + ny * (center.y() - s.cone.y)
                + nz * (center.z() - s.cone.z)
                + radius * Math.sqrt(Math.max((1 - along) * (1 + along), 0));
        return highest <= 0 ? 0 : Double.NaN;
    }

    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        Warp.toDisk(u, v, point.disk);
        double p = radius * point.disk[0];
        double q = radius * point.disk[1];
        point.set(
                Math.fma(p, basis.ax, Math.fma(q, basis.bx, center.x())),
                Math.fma(p, basis.ay, Math.fma(q, basis.by, center.y())),
                Math.fma(p, basis.az, Math.fma(q, basis.bz, center.z())));
        point.setNormal(normal.x(), normal.y(), normal.z());
    }

    @Override
    public double[] parameters() {
        return Numbers.of(sides, center, normal, new Vec3(radius, 0, 0));
    }
}

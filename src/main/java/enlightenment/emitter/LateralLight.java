package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.sampling.Warp;

/** The side of a cylinder, a cone or a frustum, without its ends, sampled evenly over its area. */
public final class LateralLight implements AreaLight {
    private final Vec3 base;
    private final Vec3 toTop;
    private final double baseRadius;
    private final double topRadius;
    private final boolean twoSided;
    private final Basis basis = new Basis();

    /** The normal's components across the axis and along it. */
    private final double outward;

    private final Vec3 alongNormal;
    private final double area;
    private final Vec3 center;
    private final double ballRadius;

    /**
     * The surface between two circles.
     *
     * @param base the centre of the first circle
     * @param toTop from there to the centre of the other one
     * @param baseRadius the radius of the first circle, at least 0
     * @param topRadius that of the other one, at least 0; one of the two is greater
     * @param twoSided whether its inner side shines as well: that of a surface without ends is seen
     */
    public LateralLight(Vec3 base, Vec3 toTop, double baseRadius, double topRadius, boolean twoSided) {
        this.base = base;
        this.toTop = toTop;
        this.baseRadius = baseRadius;
        this.topRadius = topRadius;
        this.twoSided = twoSided;
        Vec3 axis = toTop.normalized();
        basis.around(axis.x(), axis.y(), axis.z());
        double height = toTop.length();
        double gain = topRadius - baseRadius;
        double slant = new Vec3(height, gain, 0).length();
        outward = height / slant;
        alongNormal = axis.times(-gain / slant);
        area = Math.PI * (baseRadius + topRadius) * slant;
        center = base.plus(toTop.times(0.5));
        double wide = Math.max(baseRadius, topRadius);
        ballRadius =
                new Vec3(0.5 * height, wide, 0).length() * (1 + Scale.gamma(16)) + Scale.gamma(4) * center.maxAbs();
    }

    @Override
    public void aim(LightSample s, double x, double y, double z) {
        s.aim(center.x(), center.y(), center.z(), ballRadius, x, y, z);
    }

    @Override
    public void sample(LightSample s, double u, double v) {
        samplePoint(u, v, s.point);
        s.toPoint(area, twoSided);
    }

    @Override
    public double pdf(LightSample s, double dx, double dy, double dz, double distance, double cosine) {
        return LightSample.pdfOfArea(area, twoSided, distance, cosine);
    }

    @Override
    public double irradiance(LightSample s, double nx, double ny, double nz) {
        return Horizon.irradianceIfBelow(s.cone, nx, ny, nz);
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public boolean isTwoSided() {
        return twoSided;
    }

    /** The disk's angle is that around the axis; its squared radius, which is even too, chooses the circle by its circumference. */
    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        Warp.toDisk(u, v, point.disk);
        double share = point.disk[2];
        double length = Math.sqrt(share);
        double p = length > 0 ? point.disk[0] / length : 1;
        double q = length > 0 ? point.disk[1] / length : 0;
        double square = share * topRadius * topRadius + (1 - share) * baseRadius * baseRadius;
        double r = Math.sqrt(square);
        double t = r + baseRadius > 0 ? Math.min(share * (baseRadius + topRadius) / (r + baseRadius), 1) : 0;
        double x = p * basis.ax + q * basis.bx;
        double y = p * basis.ay + q * basis.by;
        double z = p * basis.az + q * basis.bz;
        point.set(
                Math.fma(r, x, Math.fma(t, toTop.x(), base.x())),
                Math.fma(r, y, Math.fma(t, toTop.y(), base.y())),
                Math.fma(r, z, Math.fma(t, toTop.z(), base.z())));
        point.setNormal(
                Math.fma(outward, x, alongNormal.x()),
                Math.fma(outward, y, alongNormal.y()),
                Math.fma(outward, z, alongNormal.z()));
    }

    @Override
    public Vec3 ballCenter() {
        return center;
    }

    @Override
    public double ballRadius() {
        return ballRadius;
    }

    @Override
    public Vec3 flatNormal() {
        return Vec3.ZERO;
    }

    @Override
    public double[] parameters() {
        return Numbers.of(twoSided, base, toTop, new Vec3(baseRadius, topRadius, 0));
    }
}

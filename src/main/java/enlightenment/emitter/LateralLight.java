package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.sampling.Warp;

/** The side of a cylinder, a cone or a frustum, without its ends, sampled uniformly over its area. */
public final class LateralLight extends CurvedLight {
    private final Vec3 base;
    private final Vec3 toTop;
    private final double baseRadius;
    private final double topRadius;
    private final Basis basis = new Basis();

    /** The normal's components perpendicular to the axis and along it. */
    private final double outward;

    private final Vec3 alongNormal;

    /** Makes a surface that emits from its front, or from both sides. */
    public LateralLight(Vec3 base, Vec3 toTop, double baseRadius, double topRadius, boolean twoSided) {
        this(base, toTop, baseRadius, topRadius, LightSides.of(twoSided));
    }

    /**
     * Makes the surface between two circles.
     *
     * @param base the centre of the first circle
     * @param toTop from there to the centre of the other one
     * @param baseRadius the radius of the first circle, at least 0
     * @param topRadius the radius of the other one, at least 0; one of the two is greater
     * @param sides that emit
     */
    public LateralLight(Vec3 base, Vec3 toTop, double baseRadius, double topRadius, LightSides sides) {
        super(
                base.plus(toTop.times(0.5)),
                ballRadius(base.plus(toTop.times(0.5)), toTop.length(), Math.max(baseRadius, topRadius)),
                Math.PI * (baseRadius + topRadius) * slant(toTop, topRadius - baseRadius),
                sides);
        this.base = base;
        this.toTop = toTop;
        this.baseRadius = baseRadius;
        this.topRadius = topRadius;
        Vec3 axis = toTop.normalized();
        basis.around(axis.x(), axis.y(), axis.z());
        double gain = topRadius - baseRadius;
        double slant = slant(toTop, gain);
        outward = toTop.length() / slant;
        alongNormal = axis.times(-gain / slant);
    }

    /** The length of a straight line on the surface, from circle to circle. */
    private static double slant(Vec3 toTop, double gain) {
        return new Vec3(toTop.length(), gain, 0).length();
    }

    private static double ballRadius(Vec3 center, double height, double wide) {
        return new Vec3(0.5 * height, wide, 0).length() * (1 + Scale.gamma(16)) + Scale.gamma(4) * center.maxAbs();
    }

    /**
     * The disk's angle becomes that around the axis; its squared radius, which is uniform as well, selects the circle in proportion to
     * circumference.
     */
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
    public double[] parameters() {
        return Numbers.of(sides, base, toTop, new Vec3(baseRadius, topRadius, 0));
    }
}

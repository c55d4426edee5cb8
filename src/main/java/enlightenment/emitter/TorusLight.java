package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** A torus that emits outwards or inwards, sampled uniformly over its area. */
public final class TorusLight extends CurvedLight {
    /** The largest number of steps of Newton's method within a bracketing interval, or of bisection where it fails. */
    private static final int MOST_STEPS = 64;

    private final Vec3 axis;
    private final double majorRadius;
    private final double minorRadius;

    /** The ratio of the minor to the major radius, at most 1. */
    private final double thickness;

    private final Basis basis = new Basis();

    /** Makes a torus that emits outwards. */
    public TorusLight(Vec3 center, Vec3 axis, double majorRadius, double minorRadius) {
        this(center, axis, majorRadius, minorRadius, LightSides.FRONT);
    }

    /**
     * Makes the torus of all points within {@code minorRadius} of a circle.
     *
     * @param axis the unit vector perpendicular to the circle's plane
     * @param majorRadius the circle's radius
     * @param minorRadius greater than 0, at most the major radius
     * @param sides that emit
     */
    public TorusLight(Vec3 center, Vec3 axis, double majorRadius, double minorRadius, LightSides sides) {
        super(
                center,
                (majorRadius + minorRadius) * (1 + Scale.gamma(8)),
                4 * Math.PI * Math.PI * majorRadius * minorRadius,
                sides);
        this.axis = axis;
        this.majorRadius = majorRadius;
        this.minorRadius = minorRadius;
        thickness = minorRadius / majorRadius;
        basis.around(axis.x(), axis.y(), axis.z());
    }

    @Override
    public void samplePoint(double u, double v, SurfacePoint point) {
        double around = 2 * Math.PI * u;
        double p = StrictMath.cos(around);
        double q = StrictMath.sin(around);
        double tube = tubeAngle(2 * Math.PI * v - Math.PI);
        double out = StrictMath.cos(tube);
        double up = StrictMath.sin(tube);
        double x = p * basis.ax + q * basis.bx;
        double y = p * basis.ay + q * basis.by;
        double z = p * basis.az + q * basis.bz;
        point.setNormal(
                Math.fma(out, x, up * axis.x()), Math.fma(out, y, up * axis.y()), Math.fma(out, z, up * axis.z()));
        double r = Math.fma(minorRadius, out, majorRadius);
        double h = minorRadius * up;
        point.set(
                Math.fma(r, x, Math.fma(h, axis.x(), ballCenter().x())),
                Math.fma(r, y, Math.fma(h, axis.y(), ballCenter().y())),
                Math.fma(r, z, Math.fma(h, axis.z(), ballCenter().z())));
    }

    /**
     * The angle ψ around the tube, from the outer equator, with ψ + (r/R)·sin ψ = m for m in −π..π: the area up to ψ is proportional to the
     * left side. Newton's steps within a bracketing interval, which is bisected where a step would leave it.
     */
    private double tubeAngle(double m) {
        double lo = -Math.PI;
        double hi = Math.PI;
        double angle = m / (1 + thickness);
        for (int k = 0; k < MOST_STEPS; k++) {
            double excess = angle + thickness * StrictMath.sin(angle) - m;
            if (excess > 0) {
                hi = angle;
            } else {
                lo = angle;
            }
            double next = angle - excess / (1 + thickness * StrictMath.cos(angle));
            next = next >= lo && next <= hi ? next : 0.5 * (lo + hi);
            if (next == angle || Math.abs(next - angle) <= Math.ulp(angle)) {
                return next;
            }
            angle = next;
        }
        return angle;
    }

    @Override
    public double[] parameters() {
        return Numbers.of(sides, ballCenter(), axis, new Vec3(majorRadius, minorRadius, 0));
    }
}

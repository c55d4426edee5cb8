package enlightenment.emitter;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.sampling.Warp;

/**
 * A spotlight: full intensity in an inner cone, none outside of an outer one, and between them the cubic smoothstep of the cosine
 * (M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th ed., 12.2.1). Cosines are kept as 1 − cos, which keeps
 * its digits in narrow cones.
 */
public final class SpotProfile implements IntensityProfile {
    /**
     * The largest number of Newton steps for the inverse of the smoothstep's integral, each within an interval that contains the root; they
     * end earlier.
     */
    private static final int STEPS = 60;

    private final Vec3 axis;
    private final double angle;

    /** 1 − cos of the inner and of the outer cone. */
    private final double inner;

    private final double outer;

    private final double solidAngle;

    /** The share of the light in the inner cone. */
    private final double innerShare;

    /**
     * Makes a spotlight.
     *
     * @param axis unit vector
     * @param angle of the outer cone, between axis and side, in degrees: above 0, at most 180
     * @param innerAngle of the inner cone, in degrees: 0..{@code angle}
     */
    public SpotProfile(Vec3 axis, double angle, double innerAngle) {
        this.axis = axis;
        this.angle = StrictMath.toRadians(angle);
        outer = oneMinusCosine(angle);
        inner = innerAngle == angle ? outer : Math.min(oneMinusCosine(innerAngle), outer);
        // The mean of the smoothstep is 1/2.
        double all = 0.5 * (inner + outer);
        solidAngle = 2 * Math.PI * all;
        innerShare = inner / all;
    }

    private static double oneMinusCosine(double degrees) {
        double sine = StrictMath.sin(0.5 * StrictMath.toRadians(degrees));
        return 2 * sine * sine;
    }

    @Override
    public double luminance(double dx, double dy, double dz) {
        // Half of the squared chord is 1 − cos, without cancellation.
        double ex = dx - axis.x();
        double ey = dy - axis.y();
        double ez = dz - axis.z();
        double height = 0.5 * (ex * ex + ey * ey + ez * ez);
        if (height <= inner) {
            return 1;
        }
        return height < outer ? smoothstep((outer - height) / (outer - inner)) : 0;
    }

    private static double smoothstep(double t) {
        return t * t * (3 - 2 * t);
    }

    @Override
    public double density(double dx, double dy, double dz) {
        return luminance(dx, dy, dz) / solidAngle;
    }

    @Override
    public double sample(double u, double v, double[] out) {
        Warp.toDisk(u, v, out);
        double share = out[2];
        double radius = Math.sqrt(share);
        double height = share < innerShare
                ? share / innerShare * inner
                : outer - (outer - inner) * falloff((1 - share) / (1 - innerShare));
        double spread = radius > 0 ? Math.sqrt(Math.max(height * (2 - height), 0)) / radius : 0;
        direct(out[0] * spread, out[1] * spread, height, out);
        return density(out[0], out[1], out[2]);
    }

    private void direct(double a, double b, double height, double[] out) {
        Basis basis = new Basis();
        basis.around(axis.x(), axis.y(), axis.z());
        double x = Math.fma(a, basis.ax, Math.fma(b, basis.bx, axis.x() - height * axis.x()));
        double y = Math.fma(a, basis.ay, Math.fma(b, basis.by, axis.y() - height * axis.y()));
        double z = Math.fma(a, basis.az, Math.fma(b, basis.bz, axis.z() - height * axis.z()));
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        out[0] = x * scale;
        out[1] = y * scale;
        out[2] = z * scale;
    }

    /** The t in 0..1 below which the share w of the smoothstep's integral lies: 2t³ − t⁴ = w, by Newton's steps in an interval. */
    private static double falloff(double w) {
        double low = 0;
        double high = 1;
        double t = 0.5;
        for (int k = 0; k < STEPS && low < high; k++) {
            double over = t * t * t * (2 - t) - w;
            if (over > 0) {
                high = t;
            } else {
                low = t;
            }
            double next = t - over / (2 * t * t * (3 - 2 * t));
            next = next > low && next < high ? next : 0.5 * (low + high);
            if (next == t) {
                break;
            }
            t = next;
        }
        return t;
    }

    @Override
    public double solidAngle() {
        return solidAngle;
    }

    @Override
    public Vec3 axis() {
        return axis;
    }

    @Override
    public double coneAngle() {
        return angle;
    }

    @Override
    public double[] parameters() {
        return new double[] {axis.x(), axis.y(), axis.z(), outer, inner};
    }
}

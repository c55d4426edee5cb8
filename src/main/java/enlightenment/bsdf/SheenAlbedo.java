package enlightenment.bsdf;

/**
 * The directional albedo E(μ) = ∫ (1 − cosθ_d)⁵ μ_i dω_i of sheen of share 1 ({@link SheenLayer}), tabulated. Made by a fixed quadrature:
 * the same on every machine.
 *
 * <p>θ_d is half of the angle γ between both directions, so that E is one integral over γ of the mean of the cosine around o.
 */
final class SheenAlbedo {
    private static final int NODES = 64;

    /** Parts of the integral over γ. */
    private static final int PARTS = 512;

    private final double[] nodes = new double[NODES + 1];

    SheenAlbedo() {
        for (int k = 0; k <= NODES; k++) {
            nodes[k] = integral((double) k / NODES);
        }
    }

    /** E at a cosine, 0..1, interpolated. */
    double at(double cosine) {
        double x = NODES * cosine;
        int k = Math.min((int) x, NODES - 1);
        return Math.fma(x - k, nodes[k + 1] - nodes[k], nodes[k]);
    }

    /** By Simpson's rule; the integrand is 0 at both ends. */
    private static double integral(double cosine) {
        double total = 0;
        for (int k = 1; k < PARTS; k++) {
            double angle = Math.PI * k / PARTS;
            double rest = 1 - StrictMath.cos(0.5 * angle);
            double lobe = rest * rest * rest * rest * rest;
            total += (k % 2 == 0 ? 2 : 4) * lobe * around(cosine, angle) * StrictMath.sin(angle);
        }
        return total * Math.PI / (3 * PARTS);
    }

    /** The integral, over the circle of directions at an angle to o, of their cosines with the normal where these are positive. */
    private static double around(double cosine, double angle) {
        double along = cosine * StrictMath.cos(angle);
        double across = Math.sqrt((1 - cosine) * (1 + cosine)) * StrictMath.sin(angle);
        if (across <= Math.abs(along)) {
            return along > 0 ? 2 * Math.PI * along : 0;
        }
        double edge = StrictMath.acos(-along / across);
        return 2 * (edge * along + across * StrictMath.sin(edge));
    }
}

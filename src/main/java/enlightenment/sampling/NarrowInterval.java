package enlightenment.sampling;

/**
 * Inversion on an interval so narrow that the density hardly varies: Σ cⱼ τʲ around its centre with c₀ = 1 and
 * |cⱼ|·widthʲ ≤ 2^-6j. The omitted terms are below 1e-17 of the sum.
 */
final class NarrowInterval {
    private static final int DEGREE = 6;

    /** Each Newton step squares the relative error, which is 2^-9 at first. */
    private static final int STEPS = 3;

    /** cⱼ, to be set before {@link #prepare}. */
    final double[] coefficients = new double[DEGREE + 1];

    private final double[] integral = new double[DEGREE + 1];
    private double half;

    /** The integral from the centre to the lower end: negative. */
    private double below;

    private double mass;

    /** @return the integral over the interval, of the density divided by its value in the centre */
    double prepare(double width) {
        half = 0.5 * width;
        for (int j = 0; j <= DEGREE; j++) {
            integral[j] = coefficients[j] / (j + 1);
        }
        below = -half * polynomial(integral, -half);
        double square = half * half;
        double sum = 0;
        for (int j = DEGREE; j >= 0; j -= 2) {
            sum = Math.fma(sum, square, integral[j]);
        }
        mass = width * sum;
        return mass;
    }

    /** The distance from the lower end at which the integral reaches the fraction u of the whole. */
    double at(double u) {
        double target = Math.fma(u, mass, below);
        double tau = half * (2 * u - 1);
        for (int i = 0; i < STEPS; i++) {
            tau -= (tau * polynomial(integral, tau) - target) / polynomial(coefficients, tau);
        }
        return half + tau;
    }

    private static double polynomial(double[] c, double x) {
        double sum = c[DEGREE];
        for (int j = DEGREE - 1; j >= 0; j--) {
            sum = Math.fma(sum, x, c[j]);
        }
        return sum;
    }
}

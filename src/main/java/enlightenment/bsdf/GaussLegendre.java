package enlightenment.bsdf;

/** Gauss-Legendre quadrature on 0..1. Not for hot code: every call computes its result anew. */
public final class GaussLegendre {
    /** Newton's method doubles the number of correct digits, two in the first guess. */
    private static final int STEPS = 8;

    private GaussLegendre() {}

    /** The i-th of n points. */
    public static double node(int n, int i) {
        return 0.5 - 0.5 * root(n, i);
    }

    /** The weight of the i-th of n points; all weights add up to 1. */
    public static double weight(int n, int i) {
        double x = root(n, i);
        double slope = slope(n, x);
        return 1 / ((1 - x) * (1 + x) * slope * slope);
    }

    private static double root(int n, int i) {
        double x = StrictMath.cos(Math.PI * (4 * i + 3) / (4 * n + 2));
        for (int step = 0; step < STEPS; step++) {
            x -= legendre(n, x) / slope(n, x);
        }
        return x;
    }

    private static double legendre(int n, double x) {
        double before = 0;
        double value = 1;
        for (int k = 1; k <= n; k++) {
            double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
            before = value;
            value = next;
        }
        return value;
    }

    private static double slope(int n, double x) {
        return n * (x * legendre(n, x) - legendre(n - 1, x)) / (x * x - 1);
    }
}

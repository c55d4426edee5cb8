package enlightenment.sampling;

import java.util.function.DoubleUnaryOperator;

/** Gauss and Legendre's quadrature with twelve points: exact for polynomials up to degree 23. */
public final class Quadrature {
    private static final int POINTS = 12;
    private static final double[] NODES = new double[POINTS];
    private static final double[] WEIGHTS = new double[POINTS];

    static {
        for (int i = 0; i < POINTS; i++) {
            // Newton's method on Legendre's polynomial, by its three-term recurrence.
            double x = StrictMath.cos(Math.PI * (i + 0.75) / (POINTS + 0.5));
            double slope = 0;
            for (int step = 0; step < 20; step++) {
                double before = 1;
                double value = x;
                for (int n = 2; n <= POINTS; n++) {
                    double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                    before = value;
                    value = next;
                }
                slope = POINTS * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            NODES[i] = x;
            WEIGHTS[i] = 2 / ((1 - x * x) * slope * slope);
        }
    }

    private Quadrature() {}

    /** The integral of f from a to b, f being smooth in between. */
    public static double panel(DoubleUnaryOperator f, double a, double b) {
        double half = 0.5 * (b - a);
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            // From the nearer end, so that positions close to an end keep their digits.
            double x = NODES[i] < 0 ? a + half * (1 + NODES[i]) : b - half * (1 - NODES[i]);
            sum += WEIGHTS[i] * f.applyAsDouble(x);
        }
        return half * sum;
    }

    /** The integral of f from a to b in equal panels. */
    public static double integral(DoubleUnaryOperator f, double a, double b, int panels) {
        double sum = 0;
        for (int i = 0; i < panels; i++) {
            sum += panel(f, a + (b - a) * i / panels, a + (b - a) * (i + 1) / panels);
        }
        return sum;
    }
}

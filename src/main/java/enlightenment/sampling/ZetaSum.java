package enlightenment.sampling;

import enlightenment.numeric.Exponential;

/**
 * Sums over the terms n = 2 … 50 of the zeta function for x ≥ 0: f(x) = Σ n^-x, its integral from x to ∞,
 * H(x) = Σ n^-x / ln n, the integral from 0 to x, and the inverses of both. Each is accurate to a few units in the last place.
 *
 * <p>49 powers would take a microsecond, so H is stored as Taylor polynomials at every quarter; all terms of H have the same
 * sign, so it loses no digits. Beyond {@link #FAR} all terms but n = 2 are below its rounding.
 */
final class ZetaSum {
    /** The original's comment: "We'll use 50 iterations". */
    private static final int TERMS = 50;

    /** (2/3)^96 is 2^-56. */
    static final int FAR = 96;

    /** ln(50)/8 to the 16th over 16! is below 1e-18. */
    private static final int DEGREE = 15;

    private static final int PER_UNIT = 4;
    private static final double[][] TAYLOR = new double[FAR * PER_UNIT + 1][DEGREE + 1];

    /** ln 2, the smallest rate of decay. */
    static final double SLOWEST = StrictMath.log(2);

    /** ln 50, the largest rate of decay. */
    static final double FASTEST = StrictMath.log(TERMS);

    /** H(0) = Σ 1/ln n: half the integral of f over the line. */
    static final double HALF_MASS;

    /** The standard deviation of the density f(|x|) / 2H(0): its variance is Σ (ln n)^-3 / Σ (ln n)^-1, twice. */
    static final double DEVIATION;

    static {
        double third = 0;
        for (int n = TERMS; n >= 2; n--) {
            double rate = StrictMath.log(n);
            third += 1 / (rate * rate * rate);
            for (int k = 0; k < TAYLOR.length; k++) {
                double c = StrictMath.exp(-rate * k / PER_UNIT) / rate;
                for (int j = 0; j <= DEGREE; j++) {
                    TAYLOR[k][j] += c;
                    c *= -rate / (j + 1);
                }
            }
        }
        HALF_MASS = TAYLOR[0][0];
        DEVIATION = Math.sqrt(2 * third / HALF_MASS);
    }

    /** Iterations stop at this relative step: the remaining error is about its square. */
    private static final double SMALL_STEP = 0x1p-30;

    private static final int MAX_STEPS = 8;

    private ZetaSum() {}

    private static int knot(double x) {
        return (int) Math.rint(x * PER_UNIT);
    }

    private static double offset(double x, int knot) {
        return x - (double) knot / PER_UNIT;
    }

    /** f(x) for x ≥ 0. */
    static double density(double x) {
        if (!(x < FAR)) {
            return Exponential.exp(-SLOWEST * x);
        }
        int k = knot(x);
        double d = offset(x, k);
        double[] c = TAYLOR[k];
        double sum = DEGREE * c[DEGREE];
        for (int j = DEGREE - 1; j >= 1; j--) {
            sum = Math.fma(sum, d, j * c[j]);
        }
        return -sum;
    }

    /** H(x) for x ≥ 0. */
    static double tail(double x) {
        if (!(x < FAR)) {
            return Exponential.exp(-SLOWEST * x) / SLOWEST;
        }
        int k = knot(x);
        return polynomial(TAYLOR[k], offset(x, k), 0);
    }

    /** H(0) − H(x) for x ≥ 0. */
    static double central(double x) {
        return knot(Math.min(x, 1)) == 0 ? -x * polynomial(TAYLOR[0], x, 1) : HALF_MASS - tail(x);
    }

    /** Σ c[from + j]·dʲ. */
    private static double polynomial(double[] c, double d, int from) {
        double sum = c[DEGREE];
        for (int j = DEGREE - 1; j >= from; j--) {
            sum = Math.fma(sum, d, c[j]);
        }
        return sum;
    }

    /** The x ≥ 0 with H(0) − H(x) = fromMiddle and H(x) = tail; each is accurate where the other is not. */
    static double inverse(double fromMiddle, double tail) {
        if (tail <= TAYLOR[TAYLOR.length - 1][0]) {
            return -Exponential.log(tail * SLOWEST) / SLOWEST;
        }
        return fromMiddle < -TAYLOR[0][1] / (2 * PER_UNIT) * 0.5 ? inverseNear(fromMiddle) : inverseTail(tail);
    }

    private static double inverseNear(double fromMiddle) {
        double x = -fromMiddle / TAYLOR[0][1];
        for (int i = 0; i < MAX_STEPS; i++) {
            double step = (fromMiddle - central(x)) / density(x);
            x += step;
            if (Math.abs(step) <= SMALL_STEP * x) {
                break;
            }
        }
        return x;
    }

    private static double inverseTail(double tail) {
        int low = 0;
        int high = TAYLOR.length - 1;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (TAYLOR[middle][0] > tail) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double x = (double) low / PER_UNIT;
        for (int i = 0; i < MAX_STEPS; i++) {
            // Newton's step for ln H, with Padé's form of the logarithm: exact up to the third order.
            double h = tail(x);
            double step = 2 * (h - tail) / (h + tail) * (h / density(x));
            x = Math.max(x + step, 0);
            if (Math.abs(step) <= SMALL_STEP * x) {
                break;
            }
        }
        return x;
    }

    /** Taylor's coefficients of f(x + τ)/f(x) into c, for x up to {@link #FAR} and a little more. */
    static void expand(double x, double[] c, double[] scratch) {
        int k = Math.min(knot(x), TAYLOR.length - 1);
        double d = offset(x, k);
        System.arraycopy(TAYLOR[k], 0, scratch, 0, DEGREE + 1);
        for (int i = 0; i <= c.length; i++) {
            for (int j = DEGREE - 1; j >= i; j--) {
                scratch[j] = Math.fma(scratch[j + 1], d, scratch[j]);
            }
        }
        for (int j = 0; j < c.length; j++) {
            c[j] = (j + 1) * scratch[j + 1] / scratch[1];
        }
    }

    /** A work space for {@link #expand}. */
    static double[] scratch() {
        return new double[DEGREE + 1];
    }
}

package enlightenment.numeric;

/**
 * The exponential function and the natural logarithm by fused operations only: the same on every machine and device, several times as
 * fast as {@link StrictMath}. The argument is reduced by powers of two, the rest is Taylor's series.
 */
public final class Exponential {
    /** ln 2 and the error of its rounding. */
    private static final double LN_2 = 0.6931471805599453;

    private static final double LN_2_REST = 2.3190468138462996e-17;

    private static final double PER_LN_2 = 1.4426950408889634;

    /** Below this the result is less than half of the smallest positive double. */
    private static final int UNDERFLOW = -746;

    /** From here up the result is infinite. */
    private static final int OVERFLOW = 710;

    private static final int MANTISSA_BITS = 52;
    private static final long BIAS = 1023;
    private static final long ROOT_HALF_BITS = Double.doubleToRawLongBits(Math.sqrt(0.5));

    private Exponential() {}

    /**
     * e to the power of x.
     *
     * @return with an error below 1 unit in the last place
     */
    public static double exp(double x) {
        if (!(x >= UNDERFLOW && x <= OVERFLOW)) {
            return x < 0 ? 0 : x > 0 ? Double.POSITIVE_INFINITY : x;
        }
        double k = Math.floor(Math.fma(x, PER_LN_2, 0.5));
        double r = Math.fma(k, -LN_2_REST, Math.fma(k, -LN_2, x));
        // |r| ≤ ln(2)/2: the first omitted term, r^14/14!, is below 2^-57. Even and odd terms apart halve the latency.
        double s = r * r;
        double even = Math.fma(s, 1.0 / 479001600, 1.0 / 3628800);
        double odd = Math.fma(s, 1.0 / 6227020800L, 1.0 / 39916800);
        even = Math.fma(s, even, 1.0 / 40320);
        odd = Math.fma(s, odd, 1.0 / 362880);
        even = Math.fma(s, even, 1.0 / 720);
        odd = Math.fma(s, odd, 1.0 / 5040);
        even = Math.fma(s, even, 1.0 / 24);
        odd = Math.fma(s, odd, 1.0 / 120);
        even = Math.fma(s, even, 0.5);
        odd = Math.fma(s, odd, 1.0 / 6);
        double rest = Math.fma(s, Math.fma(r, odd, even), r);
        // Two factors: one alone may be no normal number. Only the last product is rounded.
        int half = (int) k >> 1;
        return (rest + 1) * powerOfTwo(half) * powerOfTwo((int) k - half);
    }

    /** 2 to the power of n, a normal number. */
    private static double powerOfTwo(int n) {
        return Double.longBitsToDouble((n + BIAS) << MANTISSA_BITS);
    }

    /**
     * The natural logarithm of x.
     *
     * @return accurate to 2 units in the last place; that of {@link StrictMath} for what is no positive normal number
     */
    public static double log(double x) {
        if (!(x >= Double.MIN_NORMAL && x <= Double.MAX_VALUE)) {
            return StrictMath.log(x);
        }
        long bits = Double.doubleToRawLongBits(x);
        long k = (bits - ROOT_HALF_BITS) >> MANTISSA_BITS;
        double m = Double.longBitsToDouble(bits - (k << MANTISSA_BITS));
        // √½ ≤ m < √2; ln m = 2 artanh q with |q| ≤ 0.172: the first omitted term, q^23 · 2/23, is below 2^-60 of it.
        double q = (m - 1) / (m + 1);
        double s = q * q;
        double t = s * s;
        double even = Math.fma(t, 1.0 / 21, 1.0 / 17);
        double odd = Math.fma(t, 1.0 / 19, 1.0 / 15);
        even = Math.fma(t, even, 1.0 / 13);
        odd = Math.fma(t, odd, 1.0 / 11);
        even = Math.fma(t, even, 1.0 / 9);
        odd = Math.fma(t, odd, 1.0 / 7);
        even = Math.fma(t, even, 1.0 / 5);
        odd = Math.fma(t, odd, 1.0 / 3);
        double series = s * Math.fma(s, even, odd);
        double ofM = 2 * Math.fma(q, series, q);
        return Math.fma(k, LN_2, Math.fma(k, LN_2_REST, ofM));
    }
}

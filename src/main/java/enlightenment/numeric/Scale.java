package enlightenment.numeric;

/** Scaling by powers of two, which loses nothing, and the bounds of accumulated roundings. */
public final class Scale {
    /** What {@link #exponent} returns for zero: smaller than the exponent of every double. */
    public static final int ZERO_EXPONENT = -2000;

    /** Unit roundoff of double arithmetic, u = 2^-53. */
    public static final double UNIT_ROUNDOFF = 0x1p-53;

    private Scale() {}

    /** Exponent e with 2^e &le; |v| &lt; 2^(e+1), right for subnormal numbers too; {@link #ZERO_EXPONENT} for zero. */
    public static int exponent(double v) {
        if (v == 0) {
            return ZERO_EXPONENT;
        }
        int e = Math.getExponent(v);
        if (e >= Double.MIN_EXPONENT) {
            return e;
        }
        return Math.getExponent(v * 0x1p100) - 100;
    }

    /** v·2^k, rounded once; exact unless the result leaves the normal range. */
    public static double scalb(double v, int k) {
        return k == 0 ? v : Math.scalb(v, k);
    }

    /** γₙ = nu/(1 − nu), the relative error bound of n accumulated roundings (Higham, Accuracy and Stability, section 3.1). */
    public static double gamma(int n) {
        return n * UNIT_ROUNDOFF / (1 - n * UNIT_ROUNDOFF);
    }
}

package enlightenment.math;

import java.math.BigDecimal;
import java.math.BigInteger;

/** Exact decimals and powers of two. */
final class Decimals {
    /** The binary logarithm of ten, for estimates. */
    private static final double BITS_PER_DIGIT = 3.3219280948873626;

    private Decimals() {}

    /** v·2^k, exactly. */
    static BigDecimal timesPowerOfTwo(BigDecimal v, int k) {
        // 2^-k = 5^k / 10^k has a finite decimal expansion, so the division is exact too.
        return k >= 0
                ? v.multiply(new BigDecimal(BigInteger.TWO.pow(k)))
                : v.multiply(new BigDecimal(BigInteger.valueOf(5).pow(-k), -k));
    }

    /** The binary exponent of the number's absolute value, wrong by a few at most; that of zero is the least int. */
    static int exponent(BigDecimal v) {
        if (v.signum() == 0) {
            return Integer.MIN_VALUE;
        }
        double bits = v.unscaledValue().bitLength() - v.scale() * BITS_PER_DIGIT;
        return (int) Math.floor(bits);
    }

    /** Three numbers as a vector of any length that is handy: their ratios are right to rounding, however large they are. */
    static Vec3 direction(BigDecimal x, BigDecimal y, BigDecimal z) {
        int e = Math.max(exponent(x), Math.max(exponent(y), exponent(z)));
        if (e == Integer.MIN_VALUE) {
            return Vec3.ZERO;
        }
        return new Vec3(
                timesPowerOfTwo(x, -e).doubleValue(),
                timesPowerOfTwo(y, -e).doubleValue(),
                timesPowerOfTwo(z, -e).doubleValue());
    }
}

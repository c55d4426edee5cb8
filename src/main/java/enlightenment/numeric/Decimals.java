package enlightenment.numeric;

import java.math.BigDecimal;
import java.math.BigInteger;

/** Decimal numbers times powers of two, exactly. */
public final class Decimals {
    /** The binary logarithm of ten, for estimates. */
    private static final double BITS_PER_DIGIT = 3.3219280948873626;

    private Decimals() {}

    /** v·2^k, exactly. */
    public static BigDecimal timesPowerOfTwo(BigDecimal v, int k) {
        // 2^-k = 5^k / 10^k has a finite decimal expansion, so the division is exact too.
        return k >= 0
                ? v.multiply(new BigDecimal(BigInteger.TWO.pow(k)))
                : v.multiply(new BigDecimal(BigInteger.valueOf(5).pow(-k), -k));
    }

    /** An estimate of the binary exponent of |v|, off by a few at most; {@link Integer#MIN_VALUE} for zero. */
    public static int exponent(BigDecimal v) {
        if (v.signum() == 0) {
            return Integer.MIN_VALUE;
        }
        double bits = v.unscaledValue().bitLength() - v.scale() * BITS_PER_DIGIT;
        return (int) Math.floor(bits);
    }
}

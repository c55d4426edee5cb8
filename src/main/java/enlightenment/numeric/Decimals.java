package enlightenment.numeric;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;

/** Decimal numbers times powers of two, exactly. */
public final class Decimals {
    /** The binary logarithm of ten, for estimates. */
    private static final double BITS_PER_DIGIT = 3.3219280948873626;

    /** Powers of ten from 1 on, as long as they are doubles. */
    private static final double[] POWERS = new double[23];

    /** Below this the rounding of a product is less than a thousandth. */
    private static final double SAFE = 0x1p40;

    static {
        POWERS[0] = 1;
        for (int k = 1; k < POWERS.length; k++) {
            POWERS[k] = 10 * POWERS[k - 1];
        }
    }

    private Decimals() {}

    /** The multiple of 10^k that is nearest to v; near to the middle between two of them it may be either. */
    public static BigDecimal near(double v, int k) {
        if (Math.abs(k) < POWERS.length) {
            double n = Math.rint(k <= 0 ? v * POWERS[-k] : v / POWERS[k]);
            if (Math.abs(n) < SAFE) {
                return BigDecimal.valueOf((long) n, -k);
            }
        }
        return new BigDecimal(v).setScale(-k, RoundingMode.HALF_EVEN);
    }

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

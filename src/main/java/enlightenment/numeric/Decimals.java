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

    /** Powers of ten from 1 on. */
    private static final BigInteger[] TENS = new BigInteger[128];

    /** Bits of a quotient before it is rounded: some more than the 54 that decide. */
    private static final int QUOTIENT_BITS = 64;

    /** Below this the rounding of a product is less than a thousandth. */
    private static final double SAFE = 0x1p40;

    static {
        POWERS[0] = 1;
        for (int k = 1; k < POWERS.length; k++) {
            POWERS[k] = 10 * POWERS[k - 1];
        }
        TENS[0] = BigInteger.ONE;
        for (int k = 1; k < TENS.length; k++) {
            TENS[k] = TENS[k - 1].multiply(BigInteger.TEN);
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

    /** The nearest double, as {@link BigDecimal#doubleValue} returns, which before Java 21 takes the detour of a text. */
    public static double nearest(BigDecimal v) {
        int scale = v.scale();
        if (scale <= 0 || scale >= TENS.length || v.signum() == 0) {
            return v.doubleValue();
        }
        BigInteger digits = v.unscaledValue().abs();
        int shift = Math.max(0, QUOTIENT_BITS + TENS[scale].bitLength() - digits.bitLength());
        BigInteger[] quotient = digits.shiftLeft(shift).divideAndRemainder(TENS[scale]);
        // With any remainder the quotient is no number in the middle between two doubles.
        BigInteger rounded = quotient[1].signum() == 0 ? quotient[0] : quotient[0].setBit(0);
        // Not subnormal: v is at least 10^-127.
        return v.signum() * Math.scalb(rounded.doubleValue(), -shift);
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

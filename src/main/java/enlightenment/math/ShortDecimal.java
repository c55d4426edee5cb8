package enlightenment.math;

import java.math.BigDecimal;

/**
 * Decimals of up to 17 digits in 8 bytes: the digits as a whole number, and in the lowest bits how many of them stand after the
 * point. The form is the shortest, so equal numbers are equal forms. A {@link BigDecimal} takes 40 bytes.
 */
final class ShortDecimal {
    /** The form of every number that has too many digits. */
    static final long NONE = Long.MIN_VALUE;

    private static final int SCALE_BITS = 5;
    private static final int MAX_SCALE = (1 << SCALE_BITS) - 1;
    private static final int MAX_DIGITS = 17;

    /** Whole numbers below this are doubles. */
    private static final long EXACT = 1L << 53;

    /** Differences of whole numbers below this are no larger than a long holds. */
    private static final long LARGEST = 1L << 61;

    /** The powers of ten that a long holds, as doubles exact. */
    private static final long[] POWERS = powers();

    private ShortDecimal() {}

    private static long[] powers() {
        long[] p = new long[MAX_DIGITS + 2];
        p[0] = 1;
        for (int i = 1; i < p.length; i++) {
            p[i] = 10 * p[i - 1];
        }
        return p;
    }

    static long of(BigDecimal v) {
        BigDecimal s = v.stripTrailingZeros();
        if (s.signum() == 0) {
            return 0;
        }
        if (s.scale() < 0 && (long) s.precision() - s.scale() <= MAX_DIGITS) {
            s = s.setScale(0);
        }
        boolean fits = s.scale() >= 0 && s.scale() <= MAX_SCALE && s.precision() <= MAX_DIGITS;
        return fits ? s.unscaledValue().longValue() << SCALE_BITS | s.scale() : NONE;
    }

    /**
     * {@link #of(BigDecimal)} for the number in a text.
     *
     * @throws NumberFormatException for a text that {@link BigDecimal#BigDecimal(String)} refuses
     */
    static long of(String text) {
        int length = text.length();
        int start = length > 0 && text.charAt(0) == '-' ? 1 : 0;
        long digits = 0;
        int scale = -1;
        for (int i = start; i < length; i++) {
            char c = text.charAt(i);
            if (c >= '0' && c <= '9') {
                digits = 10 * digits + (c - '0');
                scale += scale >= 0 ? 1 : 0;
            } else if (c == '.' && scale < 0) {
                scale = 0;
            } else {
                return of(new BigDecimal(text));
            }
        }
        // One more character than digits for the point: with few characters and a digit among them, all was well.
        if (length - start > MAX_DIGITS || length - start <= (scale >= 0 ? 1 : 0)) {
            return of(new BigDecimal(text));
        }
        while (scale > 0 && digits % 10 == 0) {
            digits /= 10;
            scale--;
        }
        return (start == 0 ? digits : -digits) << SCALE_BITS | Math.max(scale, 0);
    }

    static BigDecimal value(long form) {
        return BigDecimal.valueOf(form >> SCALE_BITS, (int) form & MAX_SCALE);
    }

    /** The difference p − q, rounded once; NaN where that needs more than a division. */
    static double difference(long p, long q) {
        if (p == NONE || q == NONE) {
            return Double.NaN;
        }
        int ofP = (int) p & MAX_SCALE;
        int ofQ = (int) q & MAX_SCALE;
        int scale = Math.max(ofP, ofQ);
        if (scale >= POWERS.length) {
            return Double.NaN;
        }
        long a = p >> SCALE_BITS;
        long b = q >> SCALE_BITS;
        long timesA = POWERS[scale - ofP];
        long timesB = POWERS[scale - ofQ];
        if (Math.abs(a) > LARGEST / timesA || Math.abs(b) > LARGEST / timesB) {
            return Double.NaN;
        }
        long d = a * timesA - b * timesB;
        // Both numbers are doubles, so their quotient is rounded once.
        return Math.abs(d) <= EXACT ? (double) d / POWERS[scale] : Double.NaN;
    }
}

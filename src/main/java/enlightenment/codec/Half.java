package enlightenment.codec;

/** Numbers of 16 bits (IEEE 754, binary16): sign, 5 bits of exponent, 10 bits of fraction. */
final class Half {
    /** The largest finite one. */
    static final float MAX = 65504;

    private static final int FRACTION_BITS = 10;
    private static final int FRACTION = (1 << FRACTION_BITS) - 1;
    private static final int BIAS = 15;
    private static final int INFINITY = 31 << FRACTION_BITS;

    /** The exponent of the least normal number. */
    private static final int LEAST_EXPONENT = 1 - BIAS;

    private Half() {}

    /** The float of the same value: exact. */
    static float toFloat(short bits) {
        int exponent = bits >> FRACTION_BITS & 31;
        int fraction = bits & FRACTION;
        float size;
        if (exponent == 31) {
            size = fraction == 0 ? Float.POSITIVE_INFINITY : Float.NaN;
        } else if (exponent == 0) {
            size = Math.scalb((float) fraction, LEAST_EXPONENT - FRACTION_BITS);
        } else {
            size = Math.scalb((float) (1 << FRACTION_BITS | fraction), exponent - BIAS - FRACTION_BITS);
        }
        return bits < 0 ? -size : size;
    }

    /**
     * The nearest half, ties to the even one. What is finite stays finite: beyond ±{@link #MAX} that is the result.
     *
     * @param value no NaN
     */
    static short of(float value) {
        int sign = Float.floatToRawIntBits(value) >>> 16 & 0x8000;
        float size = Math.abs(value);
        if (size == Float.POSITIVE_INFINITY) {
            return (short) (sign | INFINITY);
        }
        float limited = Math.min(size, MAX);
        int exponent = Math.max(Math.getExponent(limited), LEAST_EXPONENT);
        // In units of the last place: at most 2^11, where a carry runs into the exponent as it should.
        int units = (int) Math.rint(Math.scalb((double) limited, FRACTION_BITS - exponent));
        return (short) (sign | (exponent - LEAST_EXPONENT << FRACTION_BITS) + units);
    }
}

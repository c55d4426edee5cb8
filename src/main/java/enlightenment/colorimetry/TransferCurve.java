package enlightenment.colorimetry;

/**
 * The sRGB transfer curve (IEC 61966-2-1), component by component: the one place that knows how linear light becomes what a screen
 * takes, and back. By {@link StrictMath}: the same bits on every machine.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class TransferCurve {
    private TransferCurve() {}

    /** Linear light 0..1 to the encoded (display-referred) value 0..1; NaN stays NaN. */
    public static double encode(double linear) {
        if (linear <= 0.0031308) {
            return 12.92 * linear;
        }
        // The same line through (1, 1), so that white stays white to the last bit.
        return 1 + 1.055 * (StrictMath.pow(linear, 1 / 2.4) - 1);
    }

    /** Encoded (display-referred) value 0..1 to linear light 0..1; NaN stays NaN. */
    public static double decode(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : StrictMath.pow((encoded + 0.055) / 1.055, 2.4);
    }
}

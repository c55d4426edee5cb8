package enlightenment.color;

import enlightenment.check.Check;
import enlightenment.colorimetry.TransferCurve;
import java.util.Objects;

/**
 * How the numbers of a picture become what a screen takes: exposure, tone and the sRGB curve. Display-referred ones are that already ({@link
 * #NONE}). Linear light is multiplied by 2<sup>exposure</sup>, goes through the tone curve, is limited to 0..1 and encoded by the sRGB curve
 * ({@link TransferCurve}), each band by itself. By {@link StrictMath} and exact roundings: the same bits on every machine. Immutable.
 */
public final class DisplayCurve {
    /** The greatest exposure either way, in stops: far beyond anything that has something to show. */
    public static final double MOST_EXPOSURE = 1000;

    /** For display-referred numbers: nothing is done. */
    public static final DisplayCurve NONE = new DisplayCurve(Color.Encoding.DISPLAY, 0, Tone.CLIP);

    /** For linear light as it is: exposure 0, clipped. */
    public static final DisplayCurve SRGB = new DisplayCurve(Color.Encoding.LINEAR, 0, Tone.CLIP);

    /** {@link Tone#FILMIC}: the factors of x² and x above, and of x², x and 1 below the line. */
    private static final double[] FILMIC = {2.51, 0.03, 2.43, 0.59, 0.14};

    /** From here on that fraction is above 1, which it reaches at 7.24; its own limit is 1.033. */
    private static final double WHITE = 8;

    private final Color.Encoding encoding;
    private final double exposure;
    private final Tone tone;

    /** 2^exposure. */
    private final double factor;

    private DisplayCurve(Color.Encoding encoding, double exposure, Tone tone) {
        this.encoding = encoding;
        this.exposure = exposure;
        this.tone = Objects.requireNonNull(tone, "tone");
        factor = StrictMath.pow(2, exposure);
    }

    /**
     * The curve for linear light.
     *
     * @param exposure in stops: 1 makes everything twice as bright; −1000..1000
     * @param tone how light becomes 0..1
     * @throws enlightenment.math.InvalidValueException (key {@code exposure}) if that is out of range or NaN
     */
    public static DisplayCurve of(double exposure, Tone tone) {
        Check.range("exposure", exposure, -MOST_EXPOSURE, MOST_EXPOSURE);
        return new DisplayCurve(Color.Encoding.LINEAR, exposure, tone);
    }

    /** What the numbers are that it is for. */
    public Color.Encoding encoding() {
        return encoding;
    }

    /** Stops by which linear light is made brighter; 0 for display-referred numbers. */
    public double exposure() {
        return exposure;
    }

    /** How light becomes 0..1; {@link Tone#CLIP} for display-referred numbers. */
    public Tone tone() {
        return tone;
    }

    /** This curve with another exposure; only for linear light. */
    public DisplayCurve withExposure(double stops) {
        if (encoding == Color.Encoding.DISPLAY) {
            throw new IllegalStateException("display-referred pictures have no exposure");
        }
        return of(stops, tone);
    }

    /** What a screen takes for this number, in 0..1 where it is linear light; NaN stays NaN. */
    public double of(double value) {
        if (encoding == Color.Encoding.DISPLAY) {
            return value;
        }
        if (value < 0) {
            // Of a colour that no screen has.
            return 0;
        }
        double light = toned(value * factor);
        return light >= 1 ? 1 : light <= 0 ? 0 : TransferCurve.encode(light);
    }

    private double toned(double x) {
        if (tone == Tone.CLIP || !(x < WHITE)) {
            return x;
        }
        return x * (FILMIC[0] * x + FILMIC[1]) / (x * (FILMIC[2] * x + FILMIC[3]) + FILMIC[4]);
    }

    /**
     * {@link #of} to 1e-6, much faster: for error estimates, which evaluate it often.
     *
     * @param value finite or infinite; NaN becomes 0
     */
    public double nearly(double value) {
        if (encoding == Color.Encoding.DISPLAY) {
            return value;
        }
        // A fraction of negative light may be anything: it has poles.
        double light = value > 0 ? toned(value * factor) : 0;
        return light >= 1 ? 1 : light > 0 ? EncodingTable.encode(light) : 0;
    }

    @Override
    public boolean equals(Object o) {
        return o instanceof DisplayCurve other
                && encoding == other.encoding
                && Double.compare(exposure, other.exposure) == 0
                && tone == other.tone;
    }

    @Override
    public int hashCode() {
        return Objects.hash(encoding, exposure, tone);
    }

    @Override
    public String toString() {
        return encoding == Color.Encoding.DISPLAY ? "display-referred" : "linear, exposure " + exposure + ", " + tone;
    }

    /** How linear light, after exposure, becomes what the transfer curve takes: 0..1. */
    public enum Tone {
        /** As it is, cut to 1: what is measured is what is seen. */
        CLIP,

        /**
         * Bent so that highlights fade slowly: x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14) in each channel, cut to 1 (Narkowicz, "ACES
         * filmic tone mapping curve", 2015).
         */
        FILMIC
    }
}

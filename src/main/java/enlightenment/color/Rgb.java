package enlightenment.color;

import enlightenment.check.Check;
import enlightenment.colorimetry.TransferCurve;

/**
 * Linear light in the bands red, green and blue: proportional to energy, not encoded and without an upper limit. Primaries and white are those of
 * Rec. 709 (ITU-R BT.709) and of sRGB. As a reflectance each component is the share that is reflected; as a radiance it is in the unit of lights,
 * which is relative: only ratios are visible.
 *
 * @param r red, finite and at least 0
 * @param g green, finite and at least 0
 * @param b blue, finite and at least 0
 */
public record Rgb(double r, double g, double b) implements Color {
    /** All components 0. */
    public static final Rgb BLACK = new Rgb(0, 0, 0);

    /** All components 1. */
    public static final Rgb WHITE = new Rgb(1, 1, 1);

    /**
     * The colour with these components.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code r}, {@code g} or {@code b}) for a component that is negative,
     *     infinite or NaN
     */
    public Rgb {
        Check.notNegative("r", r);
        Check.notNegative("g", g);
        Check.notNegative("b", b);
    }

    /** What a screen shows for a colour, as light: each component decoded by {@link TransferCurve#decode}, 0..1. */
    public static Rgb of(DisplayRgb color) {
        return new Rgb(
                TransferCurve.decode(color.r()), TransferCurve.decode(color.g()), TransferCurve.decode(color.b()));
    }

    /**
     * A grey: one number in all bands.
     *
     * @throws enlightenment.math.InvalidValueException as the constructor
     */
    public static Rgb gray(double value) {
        return new Rgb(value, value, value);
    }

    /**
     * Band by band, this times another.
     *
     * @throws enlightenment.math.InvalidValueException if a product is beyond the range of doubles
     */
    public Rgb times(Rgb other) {
        return new Rgb(r * other.r, g * other.g, b * other.b);
    }

    /** The largest component. */
    public double max() {
        return Math.max(r, Math.max(g, b));
    }

    /** Whether all components are 0. */
    public boolean isBlack() {
        return max() == 0;
    }

    @Override
    public DisplayRgb display() {
        return new DisplayRgb(shown(r), shown(g), shown(b));
    }

    private static double shown(double linear) {
        return linear < 1 ? TransferCurve.encode(linear) : 1;
    }

    @Override
    public Rgb linear() {
        return this;
    }
}

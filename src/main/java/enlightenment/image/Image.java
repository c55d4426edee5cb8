package enlightenment.image;

import enlightenment.codec.PngWriter;
import enlightenment.color.DisplayCurve;
import enlightenment.color.Encoding;
import java.util.Objects;

/**
 * A finished picture: float pixels, row by row from the top, red, green and blue interleaved, and what they mean. Those of linear
 * light become what a screen takes once, at output ({@link #displayed}). Immutable as long as nobody keeps the array that it was
 * made from.
 */
public final class Image {
    /** Twice what {@link DisplayCurve#nearly} and the roundings to floats may err by. */
    private static final double NEAR = 2.2e-6;

    private final int width;
    private final int height;
    private final float[] rgb;
    private final DisplayCurve curve;

    /**
     * A display-referred picture.
     *
     * @param width in pixels
     * @param height in pixels
     * @param rgb 3·width·height components, 0..1 where they can be displayed; taken over, not copied
     */
    public Image(int width, int height, float[] rgb) {
        this(width, height, rgb, DisplayCurve.NONE);
    }

    /**
     * A picture; one of linear light is shown as it is ({@link DisplayCurve#SRGB}).
     *
     * @param width in pixels
     * @param height in pixels
     * @param rgb 3·width·height components; taken over, not copied
     * @param encoding what they are
     */
    public Image(int width, int height, float[] rgb, Encoding encoding) {
        this(width, height, rgb, usual(encoding));
    }

    private static DisplayCurve usual(Encoding encoding) {
        return Objects.requireNonNull(encoding, "encoding") == Encoding.DISPLAY ? DisplayCurve.NONE : DisplayCurve.SRGB;
    }

    /**
     * A picture that is to be shown in a certain way.
     *
     * @param width in pixels
     * @param height in pixels
     * @param rgb 3·width·height components; taken over, not copied
     * @param curve what they are, and how they become what a screen takes
     */
    public Image(int width, int height, float[] rgb, DisplayCurve curve) {
        Objects.requireNonNull(rgb, "rgb");
        if (width < 1 || height < 1 || rgb.length != 3L * width * height) {
            throw new IllegalArgumentException(
                    width + " x " + height + " pixels need three components each, not " + rgb.length + " in all");
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
        this.curve = Objects.requireNonNull(curve, "curve");
    }

    /** What the components are. */
    public Encoding encoding() {
        return curve.encoding();
    }

    /** How the components become what a screen takes. */
    public DisplayCurve curve() {
        return curve;
    }

    /**
     * The same components, to be shown in another way.
     *
     * @throws IllegalArgumentException if the curve is for components of the other kind
     */
    public Image withCurve(DisplayCurve other) {
        if (other.encoding() != encoding()) {
            throw new IllegalArgumentException("the picture is " + encoding() + ", the curve for " + other.encoding());
        }
        return new Image(width, height, rgb, other);
    }

    /** The number of columns, at least 1. */
    public int width() {
        return width;
    }

    /** The number of rows, at least 1. */
    public int height() {
        return height;
    }

    /** Component 0 (red), 1 (green) or 2 (blue) of the pixel in column x from the left and row y from the top. */
    public float component(int x, int y, int c) {
        return rgb[3 * (y * width + x) + c];
    }

    /**
     * The same component as a screen takes it: as it is in a display-referred picture; linear light goes through the {@linkplain
     * #curve curve} in double precision, then it is rounded to a float. NaN stays NaN.
     */
    public float displayed(int x, int y, int c) {
        return displayed(component(x, y, c));
    }

    private float displayed(float value) {
        return encoding() == Encoding.DISPLAY ? value : (float) curve.of(value);
    }

    /**
     * A number that rounds to the same of the whole numbers up to a maximum as {@link #displayed} times that, halves upwards; not far
     * from it, and mostly found without the power in the curve.
     */
    float displayedFor(int maximum, int x, int y, int c) {
        return displayedFor(maximum, component(x, y, c));
    }

    private float displayedFor(int maximum, float value) {
        if (encoding() == Encoding.DISPLAY) {
            return value;
        }
        double near = curve.nearly(value);
        double scaled = near * maximum + 0.5;
        return Math.abs(scaled - Math.rint(scaled)) > NEAR * maximum ? (float) near : displayed(value);
    }

    /** The same picture as a screen takes it; this one if it is display-referred. */
    public Image toDisplay() {
        if (encoding() == Encoding.DISPLAY) {
            return this;
        }
        float[] display = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            display[i] = displayed(rgb[i]);
        }
        return new Image(width, height, display);
    }

    /** A copy of all components: 3·width·height, in the order of the constructor. */
    public float[] toArray() {
        return rgb.clone();
    }

    /**
     * The pixels for a screen: width·height numbers 0xFFRRGGBB (opaque ARGB), row by row from the top, each row from the left,
     * as {@code java.awt.image.BufferedImage.setRGB} and most windowing toolkits take them. Every component is what it is in
     * an 8-bit PNG file: {@linkplain #displayed as a screen takes it}, limited to 0..1, then rounded to the nearest of 0..255, halves
     * upwards; NaN becomes 0.
     */
    public int[] toArgb() {
        int[] argb = new int[rgb.length / 3];
        for (int i = 0; i < argb.length; i++) {
            int red = PngWriter.quantize(displayedFor(255, rgb[3 * i]), 255);
            int green = PngWriter.quantize(displayedFor(255, rgb[3 * i + 1]), 255);
            int blue = PngWriter.quantize(displayedFor(255, rgb[3 * i + 2]), 255);
            argb[i] = 0xff000000 | red << 16 | green << 8 | blue;
        }
        return argb;
    }
}

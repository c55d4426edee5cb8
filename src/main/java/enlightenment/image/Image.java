package enlightenment.image;

import enlightenment.codec.PngWriter;
import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import java.awt.image.BufferedImage;
import java.util.Objects;

/**
 * A finished picture: float pixels, row by row from the top, red, green and blue interleaved, with their display curve. Those of linear
 * light become what a screen takes once, at output ({@link #displayed}). Immutable as long as the caller does not change the array that it
 * was made from.
 */
public final class Image {
    /** Twice what {@link DisplayCurve#nearly} and the roundings to floats may err by. */
    private static final double NEAR = 2.2e-6;

    private final int width;
    private final int height;

    /** All components; null where rows are read when they are needed. */
    private final float[] rgb;

    /** Null where all components are in memory. */
    private final Rows rows;

    /** The row that was read last; those of several threads may take turns. */
    private Row last;

    private final DisplayCurve curve;

    /** A row that was read. */
    private record Row(int y, float[] components) {}

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
    public Image(int width, int height, float[] rgb, Color.Encoding encoding) {
        this(width, height, rgb, usual(encoding));
    }

    private static DisplayCurve usual(Color.Encoding encoding) {
        return Objects.requireNonNull(encoding, "encoding") == Color.Encoding.DISPLAY
                ? DisplayCurve.NONE
                : DisplayCurve.SRGB;
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
        rows = null;
        this.curve = Objects.requireNonNull(curve, "curve");
    }

    private Image(int width, int height, DisplayCurve curve, Rows rows) {
        this.width = width;
        this.height = height;
        rgb = null;
        this.rows = rows;
        this.curve = curve;
    }

    /**
     * A picture that need not fit in memory. Reading it row by row is quick, {@link #toArray} and {@link #toArgb} need memory for all of it.
     *
     * @param width in pixels
     * @param height in pixels
     * @param rows its components
     * @param curve what they are, and how they become what a screen takes
     */
    public static Image of(int width, int height, Rows rows, DisplayCurve curve) {
        if (width < 1 || height < 1 || width > Integer.MAX_VALUE / 3) {
            throw new IllegalArgumentException("no picture has " + width + " x " + height + " pixels");
        }
        return new Image(width, height, Objects.requireNonNull(curve, "curve"), Objects.requireNonNull(rows, "rows"));
    }

    /**
     * Gives up what is not in memory, such as a file: afterwards no component can be read, of this picture or one that was made from it.
     * Has no effect on a picture in memory.
     */
    public void release() {
        if (rows != null) {
            rows.release();
        }
    }

    /** What the components are. */
    public Color.Encoding encoding() {
        return curve.encoding();
    }

    /** How the components become what a screen takes. */
    public DisplayCurve curve() {
        return curve;
    }

    /**
     * This picture with another display curve.
     *
     * @throws IllegalArgumentException if the curve is for components of the other kind
     */
    public Image withCurve(DisplayCurve other) {
        if (other.encoding() != encoding()) {
            throw new IllegalArgumentException("the picture is " + encoding() + ", the curve for " + other.encoding());
        }
        return rows == null ? new Image(width, height, rgb, other) : of(width, height, rows, other);
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
        return rows == null ? rgb[3 * (y * width + x) + c] : row(y)[3 * x + c];
    }

    /** Whether all components are in memory; otherwise each row is read when it is needed, which is quick from the top to the bottom. */
    public boolean isInMemory() {
        return rows == null;
    }

    private float[] row(int y) {
        Row row = last;
        if (row == null || row.y != y) {
            float[] components = new float[3 * width];
            rows.read(y, components);
            // Only now: other threads see a record as it was when it was made.
            row = new Row(y, components);
            last = row;
        }
        return row.components;
    }

    /**
     * The component as a screen takes it. It is unchanged in a display-referred picture; linear light goes through the
     * {@linkplain #curve curve} in double precision, then it is rounded to a float. NaN stays NaN.
     */
    public float displayed(int x, int y, int c) {
        return displayed(component(x, y, c));
    }

    private float displayed(float value) {
        return encoding() == Color.Encoding.DISPLAY ? value : (float) curve.of(value);
    }

    /**
     * A number that rounds to the same of the whole numbers up to a maximum as {@link #displayed} times that, halves upwards; not far
     * from it, and mostly found without the power in the curve.
     */
    float displayedFor(int maximum, int x, int y, int c) {
        return displayedFor(maximum, component(x, y, c));
    }

    private float displayedFor(int maximum, float value) {
        if (encoding() == Color.Encoding.DISPLAY) {
            return value;
        }
        double near = curve.nearly(value);
        double scaled = near * maximum + 0.5;
        return Math.abs(scaled - Math.rint(scaled)) > NEAR * maximum ? (float) near : displayed(value);
    }

    /** This picture as a screen takes it; this one if it is display-referred. */
    public Image toDisplay() {
        if (encoding() == Color.Encoding.DISPLAY) {
            return this;
        }
        if (rows != null) {
            Rows shown = (y, components) -> {
                rows.read(y, components);
                for (int i = 0; i < components.length; i++) {
                    components[i] = displayed(components[i]);
                }
            };
            return of(width, height, shown, DisplayCurve.NONE);
        }
        float[] display = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            display[i] = displayed(rgb[i]);
        }
        return new Image(width, height, display);
    }

    /**
     * A copy of all components: 3·width·height, in the order of the constructor.
     *
     * @throws IllegalStateException if no array can hold them
     */
    public float[] toArray() {
        if (rows == null) {
            return rgb.clone();
        }
        float[] all = new float[3 * pixels()];
        for (int y = 0; y < height; y++) {
            System.arraycopy(row(y), 0, all, 3 * width * y, 3 * width);
        }
        return all;
    }

    /** The number of pixels, of which an array can hold all components. */
    private int pixels() {
        if (3L * width * height > Integer.MAX_VALUE - 8) {
            throw new IllegalStateException("no array can hold " + width + " x " + height + " pixels");
        }
        return width * height;
    }

    /**
     * The pixels for a screen: width·height numbers 0xFFRRGGBB (opaque ARGB), row by row from the top, each row from the left,
     * as {@code java.awt.image.BufferedImage.setRGB} and most windowing toolkits take them. Every component is what it is in
     * an 8-bit PNG file: {@linkplain #displayed as a screen takes it}, limited to 0..1, then rounded to the nearest of 0..255, halves
     * upwards; NaN becomes 0.
     *
     * @throws IllegalStateException if no array can hold them
     */
    public int[] toArgb() {
        int[] argb = new int[pixels()];
        for (int i = 0; i < argb.length; i++) {
            int red = PngWriter.quantize(displayedFor(255, i % width, i / width, 0), 255);
            int green = PngWriter.quantize(displayedFor(255, i % width, i / width, 1), 255);
            int blue = PngWriter.quantize(displayedFor(255, i % width, i / width, 2), 255);
            argb[i] = 0xff000000 | red << 16 | green << 8 | blue;
        }
        return argb;
    }

    /**
     * The picture for AWT, Swing and {@code javax.imageio}: of {@link BufferedImage#TYPE_INT_RGB}, the caller's own, with the pixels of
     * {@link #toArgb}. Needs no display.
     *
     * @throws IllegalStateException if no array can hold them
     */
    public BufferedImage toBufferedImage() {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, width, height, toArgb(), 0, width);
        return picture;
    }

    /** The rows of a picture that is not in memory. Must give the same numbers each time, also to several threads at once. */
    @FunctionalInterface
    public interface Rows {
        /**
         * Reads a row.
         *
         * @param y counted from 0 at the top
         * @param components gets red, green and blue of each pixel of the row, from the left
         * @throws java.io.UncheckedIOException if that fails
         */
        void read(int y, float[] components);

        /** Gives up the file, or whatever holds the rows; none is read any more. */
        default void release() {}
    }
}

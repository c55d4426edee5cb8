package enlightenment.image;

import enlightenment.codec.PngWriter;
import java.util.Objects;

/**
 * A finished picture: display-referred float pixels, row by row from the top, red, green and blue interleaved. Immutable
 * as long as nobody keeps the array that it was made from.
 */
public final class Image {
    private final int width;
    private final int height;
    private final float[] rgb;

    /**
     * @param width in pixels
     * @param height in pixels
     * @param rgb 3·width·height components, 0..1 where they can be displayed; taken over, not copied
     */
    public Image(int width, int height, float[] rgb) {
        Objects.requireNonNull(rgb, "rgb");
        if (width < 1 || height < 1 || rgb.length != 3L * width * height) {
            throw new IllegalArgumentException(
                    width + " x " + height + " pixels need three components each, not " + rgb.length + " in all");
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
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

    /** A copy of all components: 3·width·height, in the order of the constructor. */
    public float[] toArray() {
        return rgb.clone();
    }

    /**
     * The pixels for a screen: width·height numbers 0xFFRRGGBB (opaque ARGB), row by row from the top, each row from the left,
     * as {@code java.awt.image.BufferedImage.setRGB} and most windowing toolkits take them. Every component is what it is in
     * an 8-bit PNG file: limited to 0..1, then rounded to the nearest of 0..255, halves upwards; NaN becomes 0.
     */
    public int[] toArgb() {
        int[] argb = new int[rgb.length / 3];
        for (int i = 0; i < argb.length; i++) {
            int red = PngWriter.quantize(rgb[3 * i], 255);
            int green = PngWriter.quantize(rgb[3 * i + 1], 255);
            int blue = PngWriter.quantize(rgb[3 * i + 2], 255);
            argb[i] = 0xff000000 | red << 16 | green << 8 | blue;
        }
        return argb;
    }
}

package enlightenment.image;

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

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** Component 0 (red), 1 (green) or 2 (blue) of the pixel in column x from the left and row y from the top. */
    public float component(int x, int y, int c) {
        return rgb[3 * (y * width + x) + c];
    }

    /** A copy of all components. */
    public float[] toArray() {
        return rgb.clone();
    }
}

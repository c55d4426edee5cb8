package enlightenment.picture;

import enlightenment.image.Image;

/** A picture for those who look at it, in memory. */
public final class ReducedPicture {
    /** As many pixels as are read one by one in much less than a second. */
    public static final int MOST_PIXELS = 1 << 18;

    private ReducedPicture() {}

    /** Every n-th column and row of a picture, with the n of {@link #step}. */
    public static Image of(Image image, int mostPixels) {
        int step = step(image.width(), image.height(), mostPixels);
        int columns = side(image.width(), step);
        int rows = side(image.height(), step);
        float[] rgb = new float[3 * columns * rows];
        for (int i = 0; i < rgb.length; i++) {
            int pixel = i / 3;
            rgb[i] = image.component(pixel % columns * step, pixel / columns * step, i % 3);
        }
        return new Image(columns, rows, rgb, image.curve());
    }

    /** The least n for which every n-th column and row have at most this number of pixels. */
    public static int step(int width, int height, int mostPixels) {
        int step = (int) Math.max(Math.sqrt((double) width * height / mostPixels) - 1, 1);
        while ((long) side(width, step) * side(height, step) > mostPixels) {
            step++;
        }
        return step;
    }

    /** The number of columns, or rows, if only every n-th is taken. */
    public static int side(int columns, int step) {
        return (columns + step - 1) / step;
    }
}

package enlightenment.codec;

import enlightenment.check.Check;

/**
 * Where the pixels of an OpenEXR picture lie (its data window) in the whole picture (its display window), whose corner is (0, 0).
 *
 * @param x column of the first pixel
 * @param y row of the first pixel, from the top
 * @param width of the pixels that are there
 * @param height of the pixels that are there
 * @param wholeWidth of the whole picture
 * @param wholeHeight of the whole picture
 */
public record ExrWindow(int x, int y, int width, int height, int wholeWidth, int wholeHeight) {
    public ExrWindow {
        boolean isWithin = x >= 0 && y >= 0 && width > 0 && height > 0 && x <= wholeWidth - width;
        Check.that(
                isWithin && y <= wholeHeight - height,
                "window",
                "must lie in " + wholeWidth + "x" + wholeHeight + " pixels, unlike " + width + "x" + height + " at ("
                        + x + ", " + y + ")");
    }

    /** A picture of which all is there. */
    public static ExrWindow whole(int width, int height) {
        return new ExrWindow(0, 0, width, height, width, height);
    }
}

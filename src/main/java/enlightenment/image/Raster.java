package enlightenment.image;

import java.io.IOException;
import java.util.function.Supplier;

/**
 * A decoded picture file: the numbers that stand in it, not yet taken for colours. Either {@code packed} or {@code deep} is
 * null.
 *
 * @param packed 8-bit components, one number 0xRRGGBB per pixel, row by row from the top
 * @param deep 16-bit components, three per pixel
 */
record Raster(int width, int height, int[] packed, char[] deep) {
    private static final long MAXIMUM_PIXELS = 1L << 28;

    static Raster ofBytes(int width, int height) throws IOException {
        return new Raster(width, height, allocate(width, height, 4, () -> new int[width * height]), null);
    }

    static Raster ofShorts(int width, int height) throws IOException {
        return new Raster(width, height, null, allocate(width, height, 6, () -> new char[3 * width * height]));
    }

    /** @throws IOException if there are no pixels, or more than 2^28 */
    static void checkSize(long width, long height) throws IOException {
        if (width < 1 || height < 1) {
            throw new IOException("it has no pixels: " + width + " x " + height);
        }
        if (width > MAXIMUM_PIXELS || height > MAXIMUM_PIXELS || width * height > MAXIMUM_PIXELS) {
            throw new IOException(width + " x " + height + " pixels are more than the " + MAXIMUM_PIXELS + " allowed");
        }
    }

    /** Makes the array for the pixels; an IOException that names the size if there is no room. */
    static <T> T allocate(int width, int height, int bytesPerPixel, Supplier<T> array) throws IOException {
        checkSize(width, height);
        try {
            return array.get();
        } catch (OutOfMemoryError e) { // safe to catch: nothing but this one array failed
            long bytes = (long) bytesPerPixel * width * height;
            throw new IOException(
                    width + " x " + height + " pixels need " + bytes + " bytes of memory; there is not enough", e);
        }
    }
}

package enlightenment.codec;

import java.io.IOException;
import java.util.function.Supplier;

/**
 * A decoded picture file: the numbers that stand in it, not yet taken for colours. One of the three arrays is there, the
 * others are null. Pixels stand row by row from the top, components in the order red, green, blue.
 *
 * @param width in pixels
 * @param height in pixels
 * @param packed 8-bit components, one number 0xRRGGBB per pixel
 * @param deep 16-bit components, three per pixel
 * @param floats components, three per pixel
 */
public record Raster(int width, int height, int[] packed, char[] deep, float[] floats) {
    private static final long MAXIMUM_PIXELS = 1L << 28;

    static Raster ofBytes(int width, int height) throws IOException {
        return new Raster(width, height, allocate(width, height, 4, () -> new int[width * height]), null, null);
    }

    static Raster ofShorts(int width, int height) throws IOException {
        return new Raster(width, height, null, allocate(width, height, 6, () -> new char[3 * width * height]), null);
    }

    static Raster ofFloats(int width, int height) throws IOException {
        return new Raster(width, height, null, null, allocate(width, height, 12, () -> new float[3 * width * height]));
    }

    /**
     * The components as floats: whole numbers become the float next to their fraction of the maximum. May be the raster's own
     * array.
     *
     * @throws IOException if there is not enough memory
     */
    public float[] components() throws IOException {
        if (floats != null) {
            return floats;
        }
        int pixels = width * height;
        float[] rgb = allocate(width, height, 12, () -> new float[3 * pixels]);
        if (deep != null) {
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = (float) (deep[i] / 65535.0);
            }
        } else {
            for (int i = 0; i < pixels; i++) {
                rgb[3 * i] = (float) ((packed[i] >>> 16) / 255.0);
                rgb[3 * i + 1] = (float) ((packed[i] >>> 8 & 255) / 255.0);
                rgb[3 * i + 2] = (float) ((packed[i] & 255) / 255.0);
            }
        }
        return rgb;
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

    /**
     * Keeps a few bytes that claim to be a large picture from taking memory for it.
     *
     * @throws IOException if no compression makes {@code bytes} bytes of that many pixels: at best 1024 pixels become one byte, DEFLATE's
     *     limit
     */
    static void checkPlausible(int width, int height, long bytes) throws IOException {
        checkSize(width, height);
        if ((long) width * height > 65_536 + 1024 * bytes) {
            throw new IOException(bytes + " bytes are too few for " + width + " x " + height + " pixels");
        }
    }

    /** Makes the array for the pixels; an IOException that names the size if there is no room. */
    public static <T> T allocate(int width, int height, int bytesPerPixel, Supplier<T> array) throws IOException {
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

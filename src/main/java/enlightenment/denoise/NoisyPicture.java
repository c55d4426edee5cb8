package enlightenment.denoise;

/**
 * What a render knows of each pixel, row by row from the top. Arrays are not copied, and not changed.
 *
 * @param width number of columns, at least 1
 * @param height number of rows, at least 1
 * @param light linear light, the mean of the pixel's samples: red, green and blue of each pixel
 * @param quarters means of four independent shares of those samples: red, green and blue of the first share, then of the others; 12
 *     numbers per pixel. Two shares are equal where a pixel has too few samples
 * @param albedo reflectance of the first surface that is neither mirror nor glass, red, green and blue; 0 where there is none
 * @param normal unit normal of the first surface, x, y and z; 0 where there is none
 * @param position of that surface, x, y and z in units of the scene; 0 where there is none
 */
public record NoisyPicture(
        int width, int height, float[] light, float[] quarters, float[] albedo, float[] normal, float[] position) {
    /** Shares of a pixel's samples. */
    static final int QUARTERS = 4;

    /** @throws IllegalArgumentException if an array has another length than the pixels need */
    public NoisyPicture {
        long pixels = (long) width * height;
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a picture of " + width + " x " + height + " pixels");
        }
        require("light", light, 3 * pixels);
        require("quarters", quarters, 3 * QUARTERS * pixels);
        require("albedo", albedo, 3 * pixels);
        require("normal", normal, 3 * pixels);
        require("position", position, 3 * pixels);
    }

    private static void require(String name, float[] numbers, long length) {
        if (numbers.length != length) {
            throw new IllegalArgumentException(name + " has " + numbers.length + " numbers, not " + length);
        }
    }
}

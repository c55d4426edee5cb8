package enlightenment.method;

import java.util.function.BooleanSupplier;

/**
 * Shades the camera samples of a tile, many at once: their colours come in order, pixel by pixel in rows and by number in each pixel. The same numbers as a {@link enlightenment.transport.ray.Shader} gives one by one. One per thread.
 */
public interface TileShader {
    /**
     * Begins a tile.
     *
     * @param x its left column
     * @param y its upper row
     * @param width its columns
     * @param first for each of its pixels, row by row, the number of the first sample
     * @param start for each of its pixels, how many samples the pixels before it have; then the number of all
     */
    void begin(int x, int y, int width, int[] first, int[] start);

    /** Writes red, green and blue of the next sample. */
    void next(double[] rgb);

    /** Lets this end by a {@link java.util.concurrent.CancellationException} soon after the condition has become true. */
    void stopWhen(BooleanSupplier condition);
}

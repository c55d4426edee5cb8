package enlightenment.method;

import java.util.function.BooleanSupplier;

/**
 * Shades all camera samples of a tile. Their colours are returned in order, pixel by pixel in rows and by number in each pixel, and equal
 * those that a {@link enlightenment.transport.ray.Shader} returns for single samples. One per thread.
 */
public interface TileShader {
    /**
     * Begins a tile.
     *
     * @param x its left column
     * @param y its upper row
     * @param width its columns
     * @param first for each of its pixels, row by row, the number of the first sample
     * @param start for each of its pixels, the number of samples of the pixels before it; then the number of all
     */
    void begin(int x, int y, int width, int[] first, int[] start);

    /** Writes red, green and blue of the next sample. */
    void next(double[] rgb);

    /** Sets the condition of cancellation: once it holds, the work soon ends by a {@link java.util.concurrent.CancellationException}. */
    void stopWhen(BooleanSupplier condition);
}

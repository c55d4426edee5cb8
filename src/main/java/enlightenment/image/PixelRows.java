package enlightenment.image;

/** The rows of a picture that is not in memory. Must give the same numbers each time, also to several threads at once. */
@FunctionalInterface
public interface PixelRows {
    /**
     * Reads a row.
     *
     * @param y counted from 0 at the top
     * @param components gets red, green and blue of each pixel of the row, from the left
     * @throws java.io.UncheckedIOException if that fails
     */
    void read(int y, float[] components);
}

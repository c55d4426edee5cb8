package enlightenment.device;

/** A scene on a device, ready to shade samples. One per thread; to be closed. */
public interface DeviceKernel extends AutoCloseable {
    /** How many counts {@link #shade} gives. */
    int COUNTS = 5;

    /**
     * Samples of a tile: those with the indices from {@code begin} to {@code end} − 1 among all of the tile.
     *
     * @param seed of the render
     * @param first see {@link enlightenment.method.TileShader#begin}
     * @param start likewise
     */
    record Batch(long seed, int x, int y, int width, int[] first, int[] start, int begin, int end) {
        /** How many there are. */
        int size() {
            return end - begin;
        }
    }

    /**
     * Shades a batch.
     *
     * @param rgb receives three numbers for each sample
     * @param states receives 0 for each sample that was shaded; anything else is for the host to shade
     * @param counts receives how many shadow rays, mirror rays, refracted rays, light samples and lookups of images there were
     * @throws DeviceFailure if the device fails; it must not be used again
     */
    void shade(Batch batch, double[] rgb, int[] states, int[] counts);

    @Override
    void close();
}

package enlightenment.engine;

/** Makes tiles, for one thread. */
@FunctionalInterface
public interface TileMaker {
    /**
     * The tile with this number as bytes: the same on every machine, however often and in whatever order tiles are made.
     *
     * @throws IndexOutOfBoundsException if there is no such tile
     * @throws java.util.concurrent.CancellationException if it was made to be cancelled, and is
     */
    byte[] make(int tile);
}

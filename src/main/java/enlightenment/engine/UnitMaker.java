package enlightenment.engine;

/** Does units of work, for one thread, and returns the results as bytes. To be closed by that thread if it was made with a device. */
@FunctionalInterface
public interface UnitMaker extends AutoCloseable {
    /**
     * The result of the unit with this number: the same bytes on every machine, however often and in whatever order units are done, but for
     * counters where a device takes part ({@link UnitAssembly#digest}).
     *
     * @throws IndexOutOfBoundsException if there is no such unit
     * @throws java.util.concurrent.CancellationException if it was made to be cancelled, and is
     */
    byte[] make(int unit);

    @Override
    default void close() {}
}

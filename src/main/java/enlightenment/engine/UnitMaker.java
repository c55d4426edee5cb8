package enlightenment.engine;

/** Does units of work, for one thread, and gives what becomes of them as bytes. */
@FunctionalInterface
public interface UnitMaker {
    /**
     * The result of the unit with this number: the same bytes on every machine, however often and in whatever order units are done.
     *
     * @throws IndexOutOfBoundsException if there is no such unit
     * @throws java.util.concurrent.CancellationException if it was made to be cancelled, and is
     */
    byte[] make(int unit);
}

package enlightenment.measure;

/** Hears how a trade gets on. Called from several threads, one call at a time. */
@FunctionalInterface
public interface TradeListener {
    /** Hears nothing. */
    TradeListener NONE = (what, done, total) -> {};

    /**
     * Some time has passed.
     *
     * @param what what is being done, in words
     * @param doneSeconds how long it has gone on
     * @param totalSeconds how long it is expected to go on in all, at least as long
     */
    void progress(String what, double doneSeconds, double totalSeconds);
}

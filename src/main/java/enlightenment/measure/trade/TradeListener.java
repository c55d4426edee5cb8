package enlightenment.measure.trade;

/** Listener to the progress of a measurement. Called by several threads, one call at a time; must return quickly. */
@FunctionalInterface
public interface TradeListener {
    /** A listener that ignores all calls. */
    TradeListener NONE = (step, doneSeconds, totalSeconds) -> {};

    /**
     * Reports the progress; called often. An exception of the listener ends the measurement.
     *
     * @param step the current step, in words
     * @param doneSeconds seconds by the clock since the measurement began
     * @param totalSeconds expected seconds in all; at least {@code doneSeconds}
     */
    void progress(String step, double doneSeconds, double totalSeconds);
}

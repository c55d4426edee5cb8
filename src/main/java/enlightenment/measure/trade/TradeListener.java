package enlightenment.measure.trade;

/** Hears how far a measurement has come. Called from several threads, one call at a time; must return quickly. */
@FunctionalInterface
public interface TradeListener {
    /** Ignores everything. */
    TradeListener NONE = (step, doneSeconds, totalSeconds) -> {};

    /**
     * Time has passed. What the listener throws ends the measurement.
     *
     * @param step what is being done, in words
     * @param doneSeconds seconds by the clock since the measurement began
     * @param totalSeconds how long it is expected to take in all; at least {@code doneSeconds}
     */
    void progress(String step, double doneSeconds, double totalSeconds);
}

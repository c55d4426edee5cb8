package enlightenment.status;

import java.util.OptionalDouble;

/**
 * Estimate of the remaining time of a render. It does not extrapolate from compiling and planning, which differ from tiles, nor from the first tiles,
 * which are few and are slow until the just-in-time compiler is done. Thread-safe.
 */
public final class TimeLeft {
    private static final double NANO = 1e-9;

    /** Seconds after the first tile before which there is no estimate. */
    private static final double MIN_SECONDS = 2;

    /** Share of the tiles before which there is no estimate, except after {@link #LONG_SECONDS}. */
    private static final double MIN_SHARE = 0.02;

    private static final double LONG_SECONDS = 20;

    private boolean started;
    private long start;
    private long doneAtStart;
    private long doneBefore;
    private double seconds = Double.NaN;

    /** Records the progress at a time in nanoseconds. */
    public synchronized void at(long nanos, long done, long total) {
        if (done < doneBefore) {
            // The picture is rendered again from the beginning.
            started = false;
            seconds = Double.NaN;
        }
        doneBefore = done;
        if (!started) {
            // The time is measured from the end of the first tile.
            started = done > 0;
            start = nanos;
            doneAtStart = done;
            return;
        }
        double elapsed = (nanos - start) * NANO;
        boolean known = elapsed >= MIN_SECONDS && (done >= MIN_SHARE * total || elapsed >= LONG_SECONDS);
        seconds = known && done > doneAtStart ? elapsed * (total - done) / (done - doneAtStart) : Double.NaN;
    }

    /** Remaining seconds from the last {@link #at}; empty if there is no estimate yet. */
    public synchronized OptionalDouble seconds() {
        return Double.isNaN(seconds) ? OptionalDouble.empty() : OptionalDouble.of(seconds);
    }
}

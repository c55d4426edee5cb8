package enlightenment.status;

import java.util.OptionalDouble;

/**
 * An estimate of the time that a render will still take, as soon as one makes sense: the time for compiling and planning says
 * nothing about the tiles, the first tiles are slow until the just-in-time compiler is done, and a few tiles say little about the
 * others.
 */
public final class TimeLeft {
    private static final double NANO = 1e-9;

    /** There is no estimate until this many seconds after the first tile. */
    private static final double MIN_SECONDS = 2;

    /** Nor before this share of the tiles is done, except in a render that has gone on for a long time. */
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
            // The picture is rendered once more.
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

    /** Seconds from the last {@link #at}, or nothing if there is no estimate yet. */
    public synchronized OptionalDouble seconds() {
        return Double.isNaN(seconds) ? OptionalDouble.empty() : OptionalDouble.of(seconds);
    }
}

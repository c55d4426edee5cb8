package enlightenment.cli;

import java.util.OptionalDouble;

/**
 * How long a render will still take, as soon as that can be told: compiling and planning are no measure of the tiles, the first
 * tiles are slow until the just-in-time compiler is done with them, and a few tiles say little of the others.
 */
final class TimeLeft {
    private static final double NANO = 1e-9;

    /** Until so many seconds after the first tile nothing is foretold. */
    private static final double WARM = 2;

    /** Nor before this share is done, unless it takes long. */
    private static final double ENOUGH = 0.02;

    private static final double LONG = 20;

    private boolean started;
    private long start;
    private long doneAtStart;
    private long doneBefore;
    private double seconds = Double.NaN;

    /** Some more is done. */
    synchronized void at(long nanos, long done, long total) {
        if (done < doneBefore) {
            // The picture is rendered once more.
            started = false;
            seconds = Double.NaN;
        }
        doneBefore = done;
        if (!started) {
            // The first tile is the mark, not part of what is measured.
            started = done > 0;
            start = nanos;
            doneAtStart = done;
            return;
        }
        double elapsed = (nanos - start) * NANO;
        boolean known = elapsed >= WARM && (done >= ENOUGH * total || elapsed >= LONG);
        seconds = known && done > doneAtStart ? elapsed * (total - done) / (done - doneAtStart) : Double.NaN;
    }

    /** Seconds from the last {@link #at}, or nothing if they cannot be told yet. */
    synchronized OptionalDouble seconds() {
        return Double.isNaN(seconds) ? OptionalDouble.empty() : OptionalDouble.of(seconds);
    }
}

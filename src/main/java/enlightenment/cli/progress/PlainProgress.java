package enlightenment.cli.progress;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.status.TimeLeft;
import java.io.PrintStream;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/** Progress as lines of text for log files: one every two seconds at most. */
final class PlainProgress implements RenderProgress {
    private static final long SECOND = 1_000_000_000L;
    private static final long PERIOD = 2 * SECOND;

    private final PrintStream err;
    private final LongSupplier clock;
    private final TimeLeft timeLeft = new TimeLeft();
    private long last;

    /** @param clock nanoseconds */
    PlainProgress(PrintStream err, LongSupplier clock) {
        this.err = err;
        this.clock = clock;
        last = clock.getAsLong();
    }

    @Override
    public void progress(long done, long total, Supplier<Image> soFar) {
        long now = clock.getAsLong();
        timeLeft.at(now, done, total);
        // Before the first tile is finished there is nothing to report.
        if (now - last < PERIOD || done == 0 || done == total) {
            return;
        }
        last = now;
        OptionalDouble left = timeLeft.seconds();
        String estimate = left.isPresent() ? ", " + (long) Math.ceil(left.getAsDouble()) + " s left" : "";
        err.println((int) (100.0 * done / total) + " % done" + estimate);
    }
}

package enlightenment.view;

import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;

/** Ends waiting in vain: requests do not hear that a test's time is over. */
final class Deadline {
    private static final long SECONDS = 50;

    private final long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS);

    /** Fails if it has passed. */
    void check(Supplier<String> last) {
        if (System.nanoTime() - end > 0) {
            throw new AssertionError("waited in vain for " + SECONDS + " s; the last answer was " + last.get());
        }
    }
}

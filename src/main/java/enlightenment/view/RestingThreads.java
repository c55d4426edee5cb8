package enlightenment.view;

import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;

/**
 * The cancellation check of a render in the background, at which its threads rest while the view is in use: three times as long as they have
 * worked, so that a motion of the camera finds the processors nearly free. What is rendered is the same. {@link enlightenment.render.Renderer}
 * allows pauses there: priorities of threads would be simpler, but Java on Linux ignores them, and a smaller number of threads holds until the end.
 */
final class RestingThreads implements BooleanSupplier {
    private static final int RESTS_PER_WORK = 3;
    private static final long LONGEST_MILLIS = 100;
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final BooleanSupplier isCancelled;
    private final BooleanSupplier isViewInUse;
    private final LongSupplier clock;
    private final LongConsumer rest;

    /** When the thread went on with its work; 0 before its first check. */
    private final ThreadLocal<Long> resumed = ThreadLocal.withInitial(() -> 0L);

    /**
     * @param clock nanoseconds
     * @param rest lets the calling thread rest for milliseconds
     */
    RestingThreads(BooleanSupplier isCancelled, BooleanSupplier isViewInUse, LongSupplier clock, LongConsumer rest) {
        this.isCancelled = isCancelled;
        this.isViewInUse = isViewInUse;
        this.clock = clock;
        this.rest = rest;
    }

    @Override
    public boolean getAsBoolean() {
        long since = resumed.get();
        if (since != 0 && !isCancelled.getAsBoolean() && isViewInUse.getAsBoolean()) {
            rest.accept(Math.min(RESTS_PER_WORK * (clock.getAsLong() - since) / NANOS_PER_MILLI, LONGEST_MILLIS));
        }
        resumed.set(clock.getAsLong());
        return isCancelled.getAsBoolean();
    }

    /** Lets the calling thread sleep. */
    static void sleep(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

package enlightenment.view;

import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;

/**
 * The cancellation check of a background render, at which its threads pause while the view is in use. A pause is three times as long as the
 * work before it, so that a motion of the camera finds the processors nearly free. Pauses do not change the picture;
 * {@link enlightenment.render.Renderer} allows them. Thread priorities would be simpler, but Java on Linux ignores them, and a smaller number of
 * threads would hold until the end.
 */
final class RestingThreads implements BooleanSupplier {
    private static final int RESTS_PER_WORK = 3;
    private static final long LONGEST_MILLIS = 100;
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final BooleanSupplier isCancelled;
    private final BooleanSupplier isViewInUse;
    private final LongSupplier clock;
    private final LongConsumer rest;

    /** Time of the thread's last check in nanoseconds of the clock; 0 before its first. */
    private final ThreadLocal<Long> resumed = ThreadLocal.withInitial(() -> 0L);

    /**
     * @param clock nanoseconds of any origin
     * @param rest pauses the calling thread for a number of milliseconds
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

    /** Sleeps; an interrupt ends the sleep and stays set. */
    static void sleep(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

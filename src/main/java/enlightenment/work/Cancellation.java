package enlightenment.work;

import java.util.function.BooleanSupplier;

/** What ends a render before its end: its caller's wish, or that the thread it was called on is interrupted. */
public final class Cancellation implements BooleanSupplier {
    private final Thread caller = Thread.currentThread();
    private final BooleanSupplier asked;

    /** What is once seen stays so: waiting for helpers takes an interrupt from the caller's thread for a moment. */
    private volatile boolean seen;

    private Cancellation(BooleanSupplier asked) {
        this.asked = asked;
    }

    /** For a render on the current thread; to be asked from any. */
    public static BooleanSupplier of(BooleanSupplier asked) {
        return new Cancellation(asked);
    }

    @Override
    public boolean getAsBoolean() {
        if (!seen && (caller.isInterrupted() || asked.getAsBoolean())) {
            seen = true;
        }
        return seen;
    }
}

package enlightenment.transport.ray;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/** Checks for cancellation every {@link #INTERVAL} ticks; a tick is a path, a surface or a shadow ray. One per thread. */
public final class Poll {
    static final int INTERVAL = 1024;

    private BooleanSupplier cancelled = () -> false;
    private int left = INTERVAL;

    public void stopWhen(BooleanSupplier condition) {
        cancelled = condition;
    }

    public void tick() {
        if (--left <= 0) {
            poll();
        }
    }

    private void poll() {
        left = INTERVAL;
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
    }
}

package enlightenment.work;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.function.Supplier;

/** Threads that take numbered pieces of work from a counter. */
public final class Workers {
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicReference<Throwable> failure = new AtomicReference<>();
    private final int count;
    private final BooleanSupplier cancelled;

    /** While the calling thread waits for its helpers, an interrupt is taken from it: they would not see it otherwise. */
    private volatile boolean interrupted;

    private Workers(int count, BooleanSupplier cancelled) {
        this.count = count;
        this.cancelled = cancelled;
    }

    /**
     * Does pieces 0 .. count − 1 on this many threads, the calling one among them, and returns when all are done or it is
     * cancelled, which a piece may also tell by a {@link CancellationException}. What else a piece throws ends the work and is
     * thrown here. An interrupt while it waits for the helpers ends the work, too, and is set again before it returns.
     *
     * @param work makes what one thread works with; called by one thread at a time, in order
     */
    public static void run(int threads, int count, BooleanSupplier cancelled, Supplier<IntConsumer> work) {
        Workers workers = new Workers(count, cancelled);
        List<IntConsumer> each = new ArrayList<>();
        List<Thread> helpers = new ArrayList<>();
        for (int i = 0; i < Math.min(threads, count); i++) {
            IntConsumer mine = work.get();
            each.add(mine);
            if (i > 0) {
                Thread helper = new Thread(() -> workers.work(mine), "render-" + i);
                helper.setDaemon(true);
                helper.start();
                helpers.add(helper);
            }
        }
        if (!each.isEmpty()) {
            workers.work(each.get(0));
        }
        for (Thread helper : helpers) {
            workers.join(helper);
        }
        if (workers.interrupted) {
            Thread.currentThread().interrupt();
        }
        rethrow(workers.failure.get());
    }

    private void work(IntConsumer piece) {
        try {
            while (failure.get() == null && !interrupted && !cancelled.getAsBoolean()) {
                int index = next.getAndIncrement();
                if (index >= count) {
                    return;
                }
                piece.accept(index);
            }
        } catch (CancellationException e) {
            // In the middle of a piece, which is not done then.
            return;
        } catch (RuntimeException | Error e) {
            failure.compareAndSet(null, e);
        }
    }

    private void join(Thread helper) {
        while (true) {
            try {
                helper.join();
                return;
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
    }

    private static void rethrow(Throwable t) {
        if (t instanceof Error e) {
            throw e;
        }
        if (t instanceof RuntimeException e) {
            throw e;
        }
    }
}

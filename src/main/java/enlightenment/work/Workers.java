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
     * cancelled, which a piece may also tell by a {@link CancellationException}. What else a piece or the condition throws ends the work
     * and is thrown here, whatever its type: a {@link CancellationException}, too, while nothing is cancelled. An interrupt while it waits
     * for the helpers ends the work, too, and is set again before it returns.
     *
     * @param cancelled asked by all threads; once true, it stays so
     * @param work makes what one thread works with; called by this thread, in order, before there are others
     */
    public static void run(int threads, int count, BooleanSupplier cancelled, Supplier<IntConsumer> work) {
        Workers workers = new Workers(count, cancelled);
        List<IntConsumer> each = new ArrayList<>();
        for (int i = 0; i < Math.min(threads, count); i++) {
            each.add(work.get());
        }
        List<Thread> helpers = new ArrayList<>();
        for (int i = 1; i < each.size(); i++) {
            IntConsumer mine = each.get(i);
            Thread helper = new Thread(() -> workers.work(mine), "render-" + i);
            helper.setDaemon(true);
            helper.start();
            helpers.add(helper);
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
        Throwable failure = workers.failure.get();
        if (failure != null) {
            Workers.<RuntimeException>rethrow(failure);
        }
    }

    private void work(IntConsumer piece) {
        try {
            while (!isEnded()) {
                int index = next.getAndIncrement();
                if (index >= count) {
                    return;
                }
                piece.accept(index);
            }
        } catch (CancellationException e) {
            // In the middle of a piece, which is not done then; or it is a program's own, from a call of its listener.
            if (!isKnownToBeEnded()) {
                failure.compareAndSet(null, e);
            }
        } catch (Throwable t) {
            // Checked exceptions are among them: other languages than Java declare none.
            failure.compareAndSet(null, t);
        }
    }

    private boolean isEnded() {
        return failure.get() != null || interrupted || cancelled.getAsBoolean();
    }

    /** Whether that is why a piece gave up. */
    private boolean isKnownToBeEnded() {
        try {
            return isEnded();
        } catch (Throwable t) {
            // The condition cannot tell: it was the condition that threw.
            return false;
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

    /** Throws whatever it is: the compiler takes it for unchecked. */
    @SuppressWarnings("unchecked")
    private static <T extends Throwable> void rethrow(Throwable t) throws T {
        throw (T) t;
    }
}

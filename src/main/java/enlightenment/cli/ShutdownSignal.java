package enlightenment.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * The wish to end early. As a shutdown hook it hears SIGINT and SIGTERM, and holds the process until the work that goes on
 * has been brought to a good end, but not for ever.
 */
final class ShutdownSignal extends Thread implements BooleanSupplier {
    /** Long enough to write a picture to a slow disk, short enough for whoever waits at the keyboard. */
    private static final long PATIENCE_SECONDS = 30;

    private final Runnable giveUp;
    private final long patienceSeconds;
    private final CountDownLatch finished = new CountDownLatch(1);
    private volatile boolean requested;

    ShutdownSignal() {
        this(() -> {});
    }

    /** @param giveUp called where the work has not come to an end when the process ends all the same */
    ShutdownSignal(Runnable giveUp) {
        this(giveUp, PATIENCE_SECONDS);
    }

    ShutdownSignal(Runnable giveUp, long patienceSeconds) {
        super("stop");
        this.giveUp = giveUp;
        this.patienceSeconds = patienceSeconds;
    }

    /** Listens to the signals of the process from now on. */
    void listen() {
        try {
            Runtime.getRuntime().addShutdownHook(this);
        } catch (IllegalStateException alreadyEnding) {
            requested = true;
        }
    }

    /** Asks the work to end. */
    void request() {
        requested = true;
    }

    /** Tells that there is nothing to wait for any more. */
    void finished() {
        finished.countDown();
    }

    @Override
    public boolean getAsBoolean() {
        return requested;
    }

    @Override
    public void run() {
        requested = true;
        try {
            if (!finished.await(patienceSeconds, TimeUnit.SECONDS)) {
                giveUp.run();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

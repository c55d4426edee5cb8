package enlightenment.cli.terminal;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/**
 * The request to end early. As a shutdown hook it hears SIGINT and SIGTERM, and holds the process until the work under way
 * has been brought to a good end, for a limited time.
 */
public class ShutdownSignal extends Thread implements BooleanSupplier {
    /** Long enough to write a picture to a slow disk, short enough for the user who waits. */
    private static final long GRACE_SECONDS = 30;

    private final Runnable giveUp;
    private final long graceSeconds;
    private final CountDownLatch finished = new CountDownLatch(1);
    private volatile boolean requested;
    private volatile boolean processIsEnding;

    public ShutdownSignal() {
        this(() -> {});
    }

    /** @param giveUp called if the time is over and the process ends in the middle of the work */
    public ShutdownSignal(Runnable giveUp) {
        this(giveUp, GRACE_SECONDS);
    }

    ShutdownSignal(Runnable giveUp, long graceSeconds) {
        super("stop");
        this.giveUp = giveUp;
        this.graceSeconds = graceSeconds;
    }

    /** Listens to the signals of the process from now on. */
    public void listen() {
        try {
            Runtime.getRuntime().addShutdownHook(this);
        } catch (IllegalStateException alreadyEnding) {
            processIsEnding = true;
            requested = true;
        }
    }

    /** Requests that the work ends. */
    public void request() {
        requested = true;
    }

    /** The work has come to its end: there is nothing left to wait for. */
    public void finished() {
        finished.countDown();
    }

    @Override
    public boolean getAsBoolean() {
        return requested;
    }

    /**
     * Whether the process is ending by a signal, whose number becomes its exit code. The program must not call {@link System#exit} with
     * another code then: Java 17 takes a code other than 0 at once, beside that of the signal, and the faster one wins.
     */
    public boolean processIsEnding() {
        return processIsEnding;
    }

    @Override
    public void run() {
        processIsEnding = true;
        requested = true;
        try {
            if (!finished.await(graceSeconds, TimeUnit.SECONDS)) {
                giveUp.run();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}

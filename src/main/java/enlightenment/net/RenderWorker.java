package enlightenment.net;

import enlightenment.net.job.Canary;
import enlightenment.net.protocol.Limits;
import enlightenment.net.secure.SecretFile;
import enlightenment.net.secure.Tls;
import enlightenment.net.secure.Token;
import enlightenment.net.worker.Patience;
import enlightenment.net.worker.SessionEnd;
import enlightenment.net.worker.WorkerJobs;
import enlightenment.net.worker.WorkerSession;
import enlightenment.text.Plain;
import java.io.IOException;
import java.security.SecureRandom;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Renders tiles for a {@link RenderServer}. It needs no files, and neither writes nor executes anything that it is sent.
 *
 * <p>All methods may be called by several threads at once. A call makes threads of its own, which end with it; listeners are called by them.
 */
public final class RenderWorker {
    private static final int LONGEST_REASON = 2_000;

    private RenderWorker() {}

    /**
     * How a worker ended.
     *
     * @param isDone whether the server said that the picture is done
     * @param reason in words; partly those of the server, made harmless
     * @param tiles number of tiles that this worker made
     */
    public record Outcome(boolean isDone, String reason, long tiles) {
        public Outcome {
            reason = Plain.line(reason, LONGEST_REASON);
        }
    }

    /**
     * Works until the picture is done, the server refuses, shows a certificate that is not to be trusted, or has been away, or
     * of no use, for too long. Only a server that has proved that it knows the token is believed: whoever else answers there is as good as a
     * server that is away.
     *
     * @param cancelled asked a few times a second by several threads; once true, or once the calling thread is interrupted, the
     *     worker says good-bye and ends
     * @throws IOException if a file of the options cannot be used
     * @throws IllegalStateException if the library for CBOR, which is optional, is not there
     */
    public static Outcome run(String host, int port, WorkerOptions options, BooleanSupplier cancelled)
            throws IOException {
        CborLibrary.require();
        Consumer<String> log = line -> options.log.accept(Plain.line(line, LONGEST_REASON));
        byte[] token = token(options, log);
        Tls tls = tls(options);
        log.accept("computing the canary tile");
        Canary.hash();
        byte[] process = new byte[Limits.SECRET_BYTES];
        new SecureRandom().nextBytes(process);
        Thread caller = Thread.currentThread();
        BooleanSupplier isOver = () -> caller.isInterrupted() || cancelled.getAsBoolean();
        var server = new WorkerSession.ServerAddress(host, port, token, tls);
        var identity = new WorkerSession.Identity(options.version, options.threads, process, options.machine);
        AtomicReference<WorkerSession> current = new AtomicReference<>();
        RepeatedLines lines = new RepeatedLines(log);
        try (WorkerJobs jobs = new WorkerJobs(options.threads, options.version, options.tamper)) {
            return work(
                    () -> new WorkerSession(server, identity, options.timing, jobs, current, lines::say, isOver),
                    options.reconnectSeconds,
                    jobs,
                    lines,
                    isOver);
        } finally {
            lines.settle();
        }
    }

    private static byte[] token(WorkerOptions options, Consumer<String> log) throws IOException {
        if (options.tokenFile.isEmpty()) {
            return options.token.orElse(Token.NONE);
        }
        byte[] token = Token.read(options.tokenFile.get());
        SecretFile.warnIfOpen(options.tokenFile.get(), log);
        return token;
    }

    private static Tls tls(WorkerOptions options) throws IOException {
        if (options.pin.isPresent()) {
            return Tls.pinned(options.pin.get());
        }
        return options.authorities.isPresent() ? Tls.trusting(options.authorities.get()) : null;
    }

    /** Session after session, until one is final or the server has been away, or of no use, for too long. */
    private static Outcome work(
            Supplier<WorkerSession> sessions,
            double reconnectSeconds,
            WorkerJobs jobs,
            RepeatedLines log,
            BooleanSupplier cancelled) {
        Random spread = new Random();
        Patience patience = new Patience(reconnectSeconds, System.nanoTime());
        while (true) {
            WorkerSession session = sessions.get();
            SessionEnd end = session.run();
            if (cancelled.getAsBoolean()) {
                return new Outcome(false, "stopped", jobs.made());
            }
            if (end.isFinal()) {
                return new Outcome(end.isDone(), end.reason(), jobs.made());
            }
            long now = System.nanoTime();
            patience.sessionEnded(now, session.usefulNanos(), session.hasProgress());
            if (session.hasProgress()) {
                log.settle();
            }
            if (patience.isOver(now)) {
                String reason = String.format(
                        Locale.ROOT,
                        "%s for %.0f s: %s",
                        session.wasWelcome() ? "no tile was taken by the server" : "no server",
                        patience.lostSeconds(now),
                        end.reason());
                return new Outcome(false, reason, jobs.made());
            }
            log.say((session.wasWelcome() ? "lost the server: " : "") + end.reason() + "; trying again");
            // Not all workers at once.
            long pause = patience.nextPauseMillis();
            if (!pause(pause / 2 + spread.nextInt((int) pause), cancelled)) {
                return new Outcome(false, "stopped", jobs.made());
            }
        }
    }

    private static boolean pause(long millis, BooleanSupplier cancelled) {
        long end = System.nanoTime() + millis * 1_000_000L;
        while (System.nanoTime() - end < 0 && !cancelled.getAsBoolean()) {
            try {
                Thread.sleep(Math.min(millis, 50));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return false;
            }
        }
        return true;
    }
}

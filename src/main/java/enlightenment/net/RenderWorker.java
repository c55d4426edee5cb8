package enlightenment.net;

import enlightenment.check.Check;
import enlightenment.device.DeviceChoice;
import enlightenment.device.share.DeviceShare;
import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.job.Canary;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Timing;
import enlightenment.net.secure.SecretFile;
import enlightenment.net.secure.Tls;
import enlightenment.net.secure.Token;
import enlightenment.net.worker.MachineIdentity;
import enlightenment.net.worker.Patience;
import enlightenment.net.worker.SessionEnd;
import enlightenment.net.worker.WorkerJobs;
import enlightenment.net.worker.WorkerSession;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Renders tiles for a {@link RenderServer}, usually on another machine. It needs no files, and neither writes nor executes anything that it is
 * sent.
 *
 * <p>All methods may be called by several threads at once. A call makes threads of its own, which end with it; listeners are called by them.
 *
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
     * of no use, for too long. Only a server that has proved that it knows the token is believed: any other that answers there counts as a
     * server that is away.
     *
     * @param cancelled asked a few times a second by several threads; once true, or once the calling thread is interrupted, the
     *     worker says good-bye and ends
     * @throws IOException if a file of the options cannot be used
     * @throws enlightenment.math.InvalidValueException key {@code device}, if the device of the options cannot be used
     * @throws IllegalStateException if the library for CBOR, which is optional, is not there
     */
    public static Outcome run(String host, int port, Options options, BooleanSupplier cancelled) throws IOException {
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
        try (DeviceShare device = DeviceShare.chosen(options.device, log);
                WorkerJobs jobs = new WorkerJobs(options.threads, device, options.version, options.tamper)) {
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

    private static byte[] token(Options options, Consumer<String> log) throws IOException {
        if (options.tokenFile.isEmpty()) {
            return options.token.orElse(Token.NONE);
        }
        byte[] token = Token.read(options.tokenFile.get());
        SecretFile.warnIfOpen(options.tokenFile.get(), log);
        return token;
    }

    private static Tls tls(Options options) throws IOException {
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

    /**
     * How a {@link RenderWorker} works. Immutable, and valid in itself; whether files can be used is found when a worker starts.
     */
    public static final class Options {
        final int threads;
        final DeviceChoice device;
        final Optional<Path> tokenFile;
        final Optional<byte[]> token;
        final Optional<Path> authorities;
        final Optional<ContentHash> pin;
        final double reconnectSeconds;
        final Consumer<String> log;
        final String version;
        final byte[] machine;
        final Timing timing;
        final WorkerJobs.Tamper tamper;

        private Options(Builder b) {
            threads = b.threads;
            device = b.device;
            tokenFile = b.tokenFile;
            token = b.token;
            authorities = b.authorities;
            pin = b.pin;
            reconnectSeconds = b.reconnectSeconds;
            log = b.log;
            version = b.version;
            machine = b.machine;
            timing = b.timing;
            tamper = b.tamper;
        }

        /** The usual options: all processors, no token, no TLS, a minute of trying to reach a server that is away. */
        public static Builder builder() {
            return new Builder();
        }

        /** Collects options. Not for use by several threads at once; may be used again after {@link #build}. */
        public static final class Builder {
            private static final int MAX_THREADS = Limits.THREADS;

            private int threads = Runtime.getRuntime().availableProcessors();
            private DeviceChoice device = DeviceChoice.of(DeviceChoice.NONE);
            private Optional<Path> tokenFile = Optional.empty();
            private Optional<byte[]> token = Optional.empty();
            private Optional<Path> authorities = Optional.empty();
            private Optional<ContentHash> pin = Optional.empty();
            private double reconnectSeconds = 60;
            private Consumer<String> log = line -> {};
            private String version = Build.number();
            private byte[] machine = MachineIdentity.secret();
            private Timing timing = Timing.DEFAULT;
            private WorkerJobs.Tamper tamper = (tile, bytes) -> bytes;

            private Builder() {}

            /** How many tiles are rendered at once, at least 1. */
            public Builder threads(int threads) {
                this.threads = threads;
                return this;
            }

            /**
             * What renders tiles beside the threads, where it can take part: {@code cpu} for nothing, {@code opencl} or {@code opencl:N}
             * for the N-th device, from 0, that a driver for OpenCL offers, {@code auto} for a graphics processor if there is one.
             *
             * @throws enlightenment.math.InvalidValueException if it is something else
             */
            public Builder device(String word) {
                device = DeviceChoice.of(word);
                return this;
            }

            /** The file with the server's secret; the last given of this and {@link #token} counts. */
            public Builder tokenFile(Path file) {
                tokenFile = Optional.of(file);
                token = Optional.empty();
                return this;
            }

            /**
             * The server's secret itself, without white space at its ends.
             *
             * @throws IllegalArgumentException unless it has 16 to 4096 characters
             */
            public Builder token(String secret) {
                token = Optional.of(Token.of(secret));
                tokenFile = Optional.empty();
                return this;
            }

            /** TLS, with a server that these certificates (a PEM file) vouch for under the name that is connected to. */
            public Builder authorities(Path file) {
                authorities = Optional.of(file);
                return this;
            }

            /**
             * TLS, with the one server whose certificate has this SHA-256; see {@link RenderServer#pin}.
             *
             * @param pin 64 hexadecimal digits
             * @throws enlightenment.math.InvalidValueException if it is something else
             */
            public Builder pin(String pin) {
                Check.that(
                        pin.matches("[0-9a-fA-F]{64}"), "pin", "must have 64 hexadecimal digits, not \"" + pin + "\"");
                this.pin = Optional.of(ContentHash.fromBytes(HexFormat.of().parseHex(pin)));
                return this;
            }

            /** For how many seconds, at least 0, it tries to work for a server that is away, or of no use, before it gives up. */
            public Builder reconnectSeconds(double seconds) {
                reconnectSeconds = seconds;
                return this;
            }

            /** Hears what happens, a line at a time, from several threads. */
            public Builder log(Consumer<String> log) {
                this.log = Objects.requireNonNull(log);
                return this;
            }

            /** The version that it claims to be; for tests. */
            Builder version(String version) {
                this.version = version;
                return this;
            }

            /** The machine that it claims to be on; for tests. */
            Builder machine(String machine) {
                this.machine =
                        ContentHash.of(machine.getBytes(StandardCharsets.UTF_8)).toBytes();
                return this;
            }

            /** For tests. */
            Builder timing(Timing timing) {
                this.timing = timing;
                return this;
            }

            /** For tests. */
            Builder tamper(WorkerJobs.Tamper tamper) {
                this.tamper = tamper;
                return this;
            }

            /**
             * The options.
             *
             * @throws enlightenment.math.InvalidValueException if a value is out of its range, or options do not go together
             */
            public Options build() {
                Check.that(
                        threads >= 1 && threads <= MAX_THREADS,
                        "threads",
                        "must lie in 1.." + MAX_THREADS + ", not " + threads);
                Check.notNegative("reconnectSeconds", reconnectSeconds);
                Check.that(
                        pin.isEmpty() || authorities.isEmpty(),
                        "pin",
                        "must not be given together with authorities: a server is trusted by one of them");
                return new Options(this);
            }
        }
    }
}

package enlightenment.net;

import enlightenment.check.Check;
import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Timing;
import enlightenment.net.secure.Token;
import enlightenment.net.worker.MachineIdentity;
import enlightenment.net.worker.RenderPool;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * How a {@link RenderWorker} works. Immutable, and valid in itself; whether files can be used is found when a worker starts.
 */
public final class WorkerOptions {
    final int threads;
    final Optional<Path> tokenFile;
    final Optional<byte[]> token;
    final Optional<Path> authorities;
    final Optional<ContentHash> pin;
    final double reconnectSeconds;
    final Consumer<String> log;
    final String version;
    final byte[] machine;
    final Timing timing;
    final RenderPool.Tamper tamper;

    private WorkerOptions(Builder b) {
        threads = b.threads;
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
        private Optional<Path> tokenFile = Optional.empty();
        private Optional<byte[]> token = Optional.empty();
        private Optional<Path> authorities = Optional.empty();
        private Optional<ContentHash> pin = Optional.empty();
        private double reconnectSeconds = 60;
        private Consumer<String> log = line -> {};
        private String version = Build.number();
        private byte[] machine = MachineIdentity.secret();
        private Timing timing = Timing.DEFAULT;
        private RenderPool.Tamper tamper = (tile, bytes) -> bytes;

        private Builder() {}

        /** How many tiles are rendered at once, at least 1. */
        public Builder threads(int threads) {
            this.threads = threads;
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
            Check.that(pin.matches("[0-9a-fA-F]{64}"), "pin", "must have 64 hexadecimal digits, not \"" + pin + "\"");
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
        Builder tamper(RenderPool.Tamper tamper) {
            this.tamper = tamper;
            return this;
        }

        /**
         * The options.
         *
         * @throws enlightenment.math.InvalidValueException if a value is out of its range, or options do not go together
         */
        public WorkerOptions build() {
            Check.that(
                    threads >= 1 && threads <= MAX_THREADS,
                    "threads",
                    "must lie in 1.." + MAX_THREADS + ", not " + threads);
            Check.notNegative("reconnectSeconds", reconnectSeconds);
            Check.that(
                    pin.isEmpty() || authorities.isEmpty(),
                    "pin",
                    "must not be given together with authorities: a server is trusted by one of them");
            return new WorkerOptions(this);
        }
    }
}

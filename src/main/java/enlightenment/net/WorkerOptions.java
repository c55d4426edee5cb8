package enlightenment.net;

import enlightenment.math.InvalidValueException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.Optional;
import java.util.function.Consumer;

/** How a {@link RenderWorker} works. Immutable; each {@code with} gives a changed copy. */
public final class WorkerOptions implements Cloneable {
    /** All processors, no token, no TLS, a minute of patience with a server that is away. */
    public static final WorkerOptions DEFAULT = new WorkerOptions();

    int threads = Runtime.getRuntime().availableProcessors();
    Optional<Path> tokenFile = Optional.empty();
    Optional<byte[]> token = Optional.empty();
    Optional<Path> authorities = Optional.empty();
    Optional<ContentHash> pin = Optional.empty();
    double reconnectSeconds = 60;
    Consumer<String> log = line -> {};

    /** For tests. */
    String build = Build.number();

    byte[] machine = Machine.secret();
    Timing timing = Timing.USUAL;
    Tamper tamper = (tile, bytes) -> bytes;

    /** What a faulty machine makes of a tile. */
    @FunctionalInterface
    interface Tamper {
        byte[] change(int tile, byte[] bytes);
    }

    private WorkerOptions() {}

    private WorkerOptions copy() {
        try {
            return (WorkerOptions) clone();
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** How many tiles are rendered at once. */
    public WorkerOptions withThreads(int threads) {
        WorkerOptions o = copy();
        o.threads = threads;
        return o;
    }

    /** The file with the server's secret. */
    public WorkerOptions withTokenFile(Path file) {
        WorkerOptions o = copy();
        o.tokenFile = Optional.of(file);
        o.token = Optional.empty();
        return o;
    }

    /**
     * The server's secret itself.
     *
     * @throws IllegalArgumentException if it is too short or too long to be one
     */
    public WorkerOptions withToken(String secret) {
        WorkerOptions o = copy();
        o.token = Optional.of(Token.of(secret));
        o.tokenFile = Optional.empty();
        return o;
    }

    /** TLS, with a server that these certificates (a PEM file) vouch for under the name that is connected to. */
    public WorkerOptions withAuthorities(Path file) {
        WorkerOptions o = copy();
        o.authorities = Optional.of(file);
        return o;
    }

    /**
     * TLS, with the one server whose certificate has this SHA-256.
     *
     * @param pin 64 hexadecimal digits
     * @throws IllegalArgumentException if it is something else
     */
    public WorkerOptions withPin(String pin) {
        if (!pin.matches("[0-9a-fA-F]{64}")) {
            throw new InvalidValueException("pin", "must have 64 hexadecimal digits, not \"" + pin + "\"");
        }
        WorkerOptions o = copy();
        o.pin = Optional.of(ContentHash.fromBytes(HexFormat.of().parseHex(pin)));
        return o;
    }

    /** How long it tries to reach a server that is away. */
    public WorkerOptions withReconnect(double seconds) {
        WorkerOptions o = copy();
        o.reconnectSeconds = seconds;
        return o;
    }

    /** Hears what happens, a line at a time. */
    public WorkerOptions withLog(Consumer<String> log) {
        WorkerOptions o = copy();
        o.log = log;
        return o;
    }

    WorkerOptions withBuild(String build) {
        WorkerOptions o = copy();
        o.build = build;
        return o;
    }

    WorkerOptions withMachine(String machine) {
        WorkerOptions o = copy();
        o.machine = ContentHash.of(machine.getBytes(StandardCharsets.UTF_8)).toBytes();
        return o;
    }

    WorkerOptions withTiming(Timing timing) {
        WorkerOptions o = copy();
        o.timing = timing;
        return o;
    }

    WorkerOptions withTamper(Tamper tamper) {
        WorkerOptions o = copy();
        o.tamper = tamper;
        return o;
    }
}

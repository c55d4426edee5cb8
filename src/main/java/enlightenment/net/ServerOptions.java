package enlightenment.net;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.function.Consumer;

/** How a {@link RenderServer} serves. Immutable; each {@code with} gives a changed copy. */
public final class ServerOptions implements Cloneable {
    /** More workers than this cannot be connected at once; those that come too many are told to come again. */
    public static final int MOST_WORKERS = Limits.WORKERS;

    /** The port of the paper's server. */
    public static final int PORT = 6002;

    /** Loopback, the usual port, no token, all processors but one render here, nothing is waited for. */
    public static final ServerOptions DEFAULT = new ServerOptions();

    String host = "127.0.0.1";
    int port = PORT;
    int minWorkers;
    double waitSeconds = 30;
    Map<String, Double> shares = Map.of();
    Optional<Path> tokenFile = Optional.empty();
    Optional<Path> certificate = Optional.empty();
    Optional<Path> privateKey = Optional.empty();
    boolean makesCertificate;
    int statusPort = -1;
    Optional<Path> checkpoint = Optional.empty();
    int localThreads = Math.max(Runtime.getRuntime().availableProcessors() - 1, 1);
    int round = 1;
    double auditRate = CoordinatorSettings.AUDIT_RATE;
    Consumer<String> log = line -> {};

    List<String> pardoned = List.of();

    /** For tests. */
    String build = Build.number();

    ThreadFactory threads = Thread::new;

    Timing timing = Timing.USUAL;
    Path keytool = OwnCertificate.keytool();

    private ServerOptions() {}

    private ServerOptions copy() {
        try {
            return (ServerOptions) clone();
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * The address to listen at; whatever is not loopback needs a token.
     *
     * @param port 0 for any that is free
     */
    public ServerOptions withAddress(String host, int port) {
        ServerOptions o = copy();
        o.host = host;
        o.port = port;
        return o;
    }

    /** Begins when so many workers are there, or after so long. */
    public ServerOptions withWait(int minWorkers, double seconds) {
        ServerOptions o = copy();
        o.minWorkers = minWorkers;
        o.waitSeconds = seconds;
        return o;
    }

    /** First guesses of the speed of workers, by name or address, relative to 1 for all others (the paper's speed map). */
    public ServerOptions withShares(Map<String, Double> shares) {
        ServerOptions o = copy();
        o.shares = new LinkedHashMap<>(shares);
        return o;
    }

    /**
     * The file with the secret that workers must know, at least 16 characters. If there is none, a new token is made, which
     * only the file's owner may read.
     */
    public ServerOptions withTokenFile(Path file) {
        ServerOptions o = copy();
        o.tokenFile = Optional.of(file);
        return o;
    }

    /** TLS 1.3 with this certificate and private key, both as PEM files. */
    public ServerOptions withTls(Path certificate, Path privateKey) {
        ServerOptions o = copy();
        o.certificate = Optional.of(certificate);
        o.privateKey = Optional.of(privateKey);
        o.makesCertificate = false;
        return o;
    }

    /**
     * TLS 1.3 with the certificate and private key in one PEM file. If there is none it is made, with a new key and a certificate
     * that vouches for itself, and only its owner may read it: workers pin it ({@link RenderServer#pin}).
     */
    public ServerOptions withTls(Path file) {
        ServerOptions o = withTls(file, file);
        o.makesCertificate = true;
        return o;
    }

    /** A page that shows how far it is, on loopback; 0 for any port that is free. */
    public ServerOptions withStatusPort(int port) {
        ServerOptions o = copy();
        o.statusPort = port;
        return o;
    }

    /** The file that keeps what is done; a server with the same job goes on from it. */
    public ServerOptions withCheckpoint(Path file) {
        ServerOptions o = copy();
        o.checkpoint = Optional.of(file);
        return o;
    }

    /** How many threads render in this process; 0 for none as long as there are workers. */
    public ServerOptions withLocalThreads(int threads) {
        ServerOptions o = copy();
        o.localThreads = threads;
        return o;
    }

    /** The share of tiles, 0..1, that a second machine renders too, to find machines that compute wrongly. */
    public ServerOptions withAuditRate(double rate) {
        ServerOptions o = copy();
        o.auditRate = rate;
        return o;
    }

    /** Hears what happens, a line at a time. */
    public ServerOptions withLog(Consumer<String> log) {
        ServerOptions o = copy();
        o.log = log;
        return o;
    }

    /**
     * Lets machines back in that an earlier run with the same checkpoint expelled.
     *
     * @param machines by the first digits, eight or more, of what the log and the status call them
     */
    public ServerOptions withPardoned(List<String> machines) {
        ServerOptions o = copy();
        o.pardoned = List.copyOf(machines);
        return o;
    }

    ServerOptions withThreads(ThreadFactory threads) {
        ServerOptions o = copy();
        o.threads = threads;
        return o;
    }

    /** For the same picture with more samples: at the same ports, with a checkpoint of its own beside that of the first. */
    ServerOptions following(int port, int statusPort, int round) {
        ServerOptions o = withAddress(host, port);
        o.statusPort = statusPort;
        o.round = round;
        return o;
    }

    /** Where this render of the picture is kept: the file that was given, and FILE.2, FILE.3 … for those that follow. */
    Optional<Path> checkpointOfRound() {
        return round == 1 ? checkpoint : checkpoint.map(file -> file.resolveSibling(file.getFileName() + "." + round));
    }

    ServerOptions withBuild(String build) {
        ServerOptions o = copy();
        o.build = build;
        return o;
    }

    ServerOptions withKeytool(Path keytool) {
        ServerOptions o = copy();
        o.keytool = keytool;
        return o;
    }

    ServerOptions withTiming(Timing timing) {
        ServerOptions o = copy();
        o.timing = timing;
        return o;
    }

    /**
     * Fails unless these options go together.
     *
     * @throws IllegalArgumentException with the reason
     */
    void check() throws UnknownHostException {
        if (!InetAddress.getByName(host).isLoopbackAddress() && tokenFile.isEmpty()) {
            throw new IllegalArgumentException("beyond this machine (" + host
                    + ") workers need a token: give a file for it, which is made if there is none");
        }
        if (!pardoned.isEmpty() && checkpoint.isEmpty()) {
            throw new IllegalArgumentException("nobody is expelled yet: only a checkpoint remembers expulsions");
        }
        for (Map.Entry<String, Double> share : shares.entrySet()) {
            if (!(share.getValue() > 0 && share.getValue() < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(
                        "the share of " + share.getKey() + " must be greater than 0, not " + share.getValue());
            }
        }
    }

    /** The weight of a worker of this name at this address. */
    double weight(String name, String address) {
        return shares.getOrDefault(name, shares.getOrDefault(address, 1.0));
    }
}

package enlightenment.net;

import enlightenment.check.Check;
import enlightenment.device.DeviceChoice;
import enlightenment.engine.FilmRoom;
import enlightenment.job.Build;
import enlightenment.net.job.PictureRoom;
import enlightenment.net.protocol.Limits;
import enlightenment.net.protocol.Timing;
import enlightenment.net.schedule.CoordinatorSettings;
import enlightenment.net.secure.OwnCertificate;
import enlightenment.net.secure.Secrets;
import enlightenment.net.worker.MachineIdentity;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.function.Consumer;

/**
 * The options of a {@link RenderServer}: its address, its token, where it keeps results. Immutable, and valid in itself: {@link Builder#build}
 * refuses what no server can do. Whether files and ports can be used is found when a server starts.
 */
public final class ServerOptions {
    /** The largest number of workers that are connected at once; those beyond it are refused and may try again. */
    public static final int MAX_WORKERS = Limits.WORKERS;

    /** The usual port, that of the paper's server. */
    public static final int DEFAULT_PORT = 6002;

    /** The usual share of tiles that a second machine renders too, see {@link Builder#auditRate}. */
    public static final double DEFAULT_AUDIT_RATE = CoordinatorSettings.AUDIT_RATE;

    private static final int MAX_PORT = 65_535;

    final String host;
    final int port;
    final int minWorkers;
    final double waitSeconds;
    final Map<String, Double> shares;
    final Optional<Path> tokenFile;
    final Optional<Path> certificate;
    final Optional<Path> privateKey;
    final boolean makesCertificate;
    final int statusPort;
    final Optional<Path> checkpoint;
    final List<RenderResult.Archive> archives;
    final int localThreads;
    final DeviceChoice device;
    final double auditRate;
    final List<String> pardoned;
    final Consumer<String> log;

    final String version;
    final ThreadFactory threads;
    final Timing timing;
    final Path keytool;

    /** The places where finished pixels may be: memory, or a scratch file. */
    final FilmRoom room;

    private ServerOptions(Builder b) {
        host = b.host;
        port = b.port;
        minWorkers = b.minWorkers;
        waitSeconds = b.waitSeconds;
        shares = b.shares;
        tokenFile = b.tokenFile;
        certificate = b.certificate;
        privateKey = b.privateKey;
        makesCertificate = b.makesCertificate;
        statusPort = b.statusPort;
        checkpoint = b.checkpoint;
        archives = b.archives;
        localThreads = b.localThreads;
        device = b.device;
        auditRate = b.auditRate;
        pardoned = b.pardoned;
        log = b.log;
        version = b.version;
        threads = b.threads;
        timing = b.timing;
        keytool = b.keytool;
        room = b.room;
    }

    /**
     * The usual options: loopback, the usual port, no token, no TLS, no status page, no checkpoint; all processors but one
     * render in this process, and nothing is waited for.
     */
    public static Builder builder() {
        return new Builder();
    }

    /** A builder that starts from these options. */
    public Builder toBuilder() {
        return new Builder(this);
    }

    /** Collects options. Not for use by several threads at once; may be used again after {@link #build}. */
    public static final class Builder {
        private String host = "127.0.0.1";
        private int port = DEFAULT_PORT;
        private int minWorkers;
        private double waitSeconds = 30;
        private Map<String, Double> shares = Map.of();
        private Optional<Path> tokenFile = Optional.empty();
        private Optional<Path> certificate = Optional.empty();
        private Optional<Path> privateKey = Optional.empty();
        private boolean makesCertificate;
        private int statusPort = -1;
        private Optional<Path> checkpoint = Optional.empty();
        private List<RenderResult.Archive> archives = List.of();
        private DeviceChoice device = DeviceChoice.of(DeviceChoice.NONE);
        private int localThreads = Math.max(Runtime.getRuntime().availableProcessors() - 1, 1);
        private double auditRate = DEFAULT_AUDIT_RATE;
        private List<String> pardoned = List.of();
        private Consumer<String> log = line -> {};
        private String version = Build.number();
        private ThreadFactory threads = Thread::new;
        private Timing timing = Timing.DEFAULT;
        private Path keytool = OwnCertificate.keytool();
        private FilmRoom room = FilmRoom.MEMORY;

        private Builder() {}

        private Builder(ServerOptions o) {
            host = o.host;
            port = o.port;
            minWorkers = o.minWorkers;
            waitSeconds = o.waitSeconds;
            shares = o.shares;
            tokenFile = o.tokenFile;
            certificate = o.certificate;
            privateKey = o.privateKey;
            makesCertificate = o.makesCertificate;
            statusPort = o.statusPort;
            checkpoint = o.checkpoint;
            archives = o.archives;
            localThreads = o.localThreads;
            device = o.device;
            auditRate = o.auditRate;
            pardoned = o.pardoned;
            log = o.log;
            version = o.version;
            threads = o.threads;
            timing = o.timing;
            keytool = o.keytool;
            room = o.room;
        }

        /**
         * The address to listen at; whatever is not loopback needs a {@linkplain #tokenFile token}.
         *
         * @param host a name or an address of this machine; {@code 0.0.0.0} for all of its IPv4 addresses
         * @param port 1..65535; 0 for any that is free
         */
        public Builder address(String host, int port) {
            this.host = Objects.requireNonNull(host);
            this.port = port;
            return this;
        }

        /**
         * Rendering begins when {@code minWorkers} have joined, or after {@code seconds}. Where no worker is connected for
         * that time later on, this process renders by itself.
         *
         * @param minWorkers 0 to {@value #MAX_WORKERS}; 0 begins at once, as is usual
         * @param seconds at least 0; 30 as is usual
         */
        public Builder awaitWorkers(int minWorkers, double seconds) {
            this.minWorkers = minWorkers;
            waitSeconds = seconds;
            return this;
        }

        /**
         * First guesses of the speed of workers, relative to 1 for all others (the paper's speed map); measured speeds
         * replace them.
         *
         * @param shares by the worker's name, that of its machine, or its address; each greater than 0
         */
        public Builder shares(Map<String, Double> shares) {
            this.shares = Map.copyOf(shares);
            return this;
        }

        /**
         * The file with the secret that workers must know, 16 to 4096 characters. If there is none, a new token is made, which
         * only the file's owner may read.
         */
        public Builder tokenFile(Path file) {
            tokenFile = Optional.of(file);
            return this;
        }

        /**
         * TLS 1.3 with a certificate and private key that are there already.
         *
         * @param certificate PEM file of the certificate and those that vouch for it
         * @param privateKey PEM file of its private key (PKCS #8, not encrypted)
         */
        public Builder tls(Path certificate, Path privateKey) {
            this.certificate = Optional.of(certificate);
            this.privateKey = Optional.of(privateKey);
            makesCertificate = false;
            return this;
        }

        /**
         * TLS 1.3 with the certificate and private key in one PEM file. If there is none it is made, with a new key and a
         * self-signed certificate, and only its owner may read it: workers pin it ({@link RenderServer#pin}).
         */
        public Builder tls(Path file) {
            tls(file, file);
            makesCertificate = true;
            return this;
        }

        /**
         * A page that shows how far the render is, on loopback only.
         *
         * @param port 1..65535; 0 for any that is free; -1 for no page, as is usual
         */
        public Builder statusPort(int port) {
            statusPort = port;
            return this;
        }

        /**
         * The file that keeps what is done, also of renders with more samples that follow the first; a server with the same scene and
         * settings goes on from it, as does a render in one process.
         */
        public Builder checkpoint(Path file) {
            checkpoint = Optional.of(file);
            return this;
        }

        /**
         * Archives that store finished units as well, and that a server resumes from; one thread at a time uses them. The caller that
         * opened them closes them, after the server.
         */
        public Builder archives(List<RenderResult.Archive> all) {
            archives = List.copyOf(all);
            return this;
        }

        /** The folder for a picture that is too large for the memory; without one such a picture is refused. */
        public Builder scratch(RenderRequest.ScratchFolder folder) {
            room = PictureRoom.of(Optional.of(folder));
            return this;
        }

        /** The number of threads that render in this process; with 0 none do as long as there are workers. */
        public Builder localThreads(int threads) {
            localThreads = threads;
            return this;
        }

        /**
         * What renders in this process beside its threads, where it can take part: as {@link RenderWorker.Options.Builder#device}.
         *
         * @throws enlightenment.math.InvalidValueException if it is something else
         */
        public Builder device(String word) {
            device = DeviceChoice.of(word);
            return this;
        }

        /** The share of tiles, 0..1, that a second machine renders too, to find machines that compute wrongly. */
        public Builder auditRate(double rate) {
            auditRate = rate;
            return this;
        }

        /**
         * Lets machines back in that an earlier run with the same checkpoint expelled. A server does not start if one of them
         * is not expelled.
         *
         * @param machines by the first digits, eight or more, of what the log and the status call them
         */
        public Builder pardoned(List<String> machines) {
            pardoned = List.copyOf(machines);
            return this;
        }

        /** A listener that receives log lines, from several threads and sometimes under a lock: it should return soon. */
        public Builder log(Consumer<String> log) {
            this.log = Objects.requireNonNull(log);
            return this;
        }

        /** The version that workers must have; for tests. */
        Builder version(String version) {
            this.version = version;
            return this;
        }

        /** The factory of the threads of connections and of the server itself; for tests. */
        Builder threads(ThreadFactory threads) {
            this.threads = threads;
            return this;
        }

        /** For tests. */
        Builder timing(Timing timing) {
            this.timing = timing;
            return this;
        }

        /** For tests. */
        Builder keytool(Path keytool) {
            this.keytool = keytool;
            return this;
        }

        /**
         * The options. Where there is no token the host's name is resolved, which may ask the network.
         *
         * @throws enlightenment.math.InvalidValueException if a value is out of its range, or options do not go together
         */
        public ServerOptions build() {
            port("port", port, 0);
            port("statusPort", statusPort, -1);
            Check.that(
                    minWorkers >= 0 && minWorkers <= MAX_WORKERS,
                    "minWorkers",
                    "must lie in 0.." + MAX_WORKERS + ", not " + minWorkers);
            Check.notNegative("waitSeconds", waitSeconds);
            Check.that(localThreads >= 0, "localThreads", "must be at least 0, not " + localThreads);
            Check.range("auditRate", auditRate, 0, 1);
            shares.forEach((name, share) -> Check.positive("shares/" + name, share));
            Check.that(
                    tokenFile.isPresent() || isLoopback(),
                    "tokenFile",
                    "beyond this machine (" + host
                            + ") workers need a token: give a file for it, which is made if there is none");
            Check.that(
                    pardoned.isEmpty() || checkpoint.isPresent(),
                    "pardoned",
                    "no machine is expelled yet: only a checkpoint remembers expulsions");
            return new ServerOptions(this);
        }

        private static void port(String key, int port, int lowest) {
            Check.that(
                    port >= lowest && port <= MAX_PORT,
                    key,
                    "must lie in " + lowest + ".." + MAX_PORT + ", not " + port);
        }

        private boolean isLoopback() {
            try {
                return InetAddress.getByName(host).isLoopbackAddress();
            } catch (UnknownHostException e) {
                return false;
            }
        }
    }

    /** These options with other {@linkplain Builder#archives archives}. */
    public ServerOptions withArchives(List<RenderResult.Archive> all) {
        return toBuilder().archives(all).build();
    }

    /** Options for a render of this picture with more samples, at these ports. */
    ServerOptions following(int port, int statusPort) {
        return toBuilder()
                .address(host, port)
                .statusPort(statusPort)
                .pardoned(List.of())
                .build();
    }

    /** The files of the server's secrets. */
    Secrets.Sources secrets() {
        return new Secrets.Sources(tokenFile, certificate, privateKey, makesCertificate, keytool);
    }

    /** The weight of a worker of this name at this address. */
    double weight(String name, String address) {
        String machine = MachineIdentity.machineOf(name);
        return shares.getOrDefault(name, shares.getOrDefault(machine, shares.getOrDefault(address, 1.0)));
    }
}

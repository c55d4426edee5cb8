package enlightenment.net;

import enlightenment.file.FileFailure;
import enlightenment.image.Image;
import enlightenment.listen.Acceptor;
import enlightenment.listen.ServerLog;
import enlightenment.math.InvalidValueException;
import enlightenment.net.schedule.Snapshot;
import enlightenment.net.secure.Secrets;
import enlightenment.net.server.Connections;
import enlightenment.net.server.Lobby;
import enlightenment.net.server.ServerConnection;
import enlightenment.net.server.ServerJob;
import enlightenment.render.RenderProgress;
import enlightenment.status.State;
import enlightenment.status.Status;
import enlightenment.status.StatusServer;
import enlightenment.status.StatusSource;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * One render of a server's picture, with the ports that it listens at and the threads that serve it. To workers a round that
 * follows another is a server that was started anew.
 */
final class ServerRound implements StatusSource {
    private static final long TICK_MILLIS = 200;
    private static final long ACCEPT_END_TIMEOUT_MILLIS = 2_000;

    private final ServerOptions options;
    private final ServerLog log;
    private final ServerJob job;
    private final Connections connections = new Connections();
    private final Coordination coordination;
    private final Acceptor acceptor;
    private final StatusServer status;

    /** The thread that listens. */
    private Thread accepting;

    private ServerRound(ServerOptions options, ServerLog log, Secrets secrets, ServerJob job) throws IOException {
        this.options = options;
        this.log = log;
        this.job = job;
        coordination = new Coordination(options, log, secrets, job, connections);
        try {
            acceptor = openAcceptor();
            status = openStatus();
        } catch (IOException e) {
            job.close();
            throw e;
        }
    }

    private Acceptor openAcceptor() throws IOException {
        try {
            return Acceptor.at(InetAddress.getByName(options.host), options.port, log);
        } catch (IOException e) {
            throw new IOException(
                    "cannot listen at " + options.host + ":" + options.port + ": " + FileFailure.reason(e), e);
        }
    }

    private StatusServer openStatus() throws IOException {
        try {
            return options.statusPort < 0
                    ? null
                    : StatusServer.start(this, options.statusPort, options.threads, log, System::nanoTime);
        } catch (IOException e) {
            acceptor.close();
            throw new IOException("cannot show a status page at " + options.statusPort + ": " + e.getMessage(), e);
        }
    }

    /** Begins to listen. */
    static ServerRound start(ServerOptions options, ServerLog log, Secrets secrets, ServerJob job) throws IOException {
        Optional<Path> checkpoint = options.checkpoint;
        if (checkpoint.isPresent()) {
            job.open(checkpoint.get(), options.pardoned);
        }
        job.keepIn(options.archives);
        ServerRound round = new ServerRound(options, log, secrets, job);
        Lobby lobby = new Lobby(round.coordination, round.connections, options.threads, log);
        round.accepting = lobby.startThread(() -> round.acceptor.accept(lobby::welcome, lobby::makeRoom), "accept");
        lobby.startThread(round::tickAll, "tick");
        return round;
    }

    /**
     * The render that goes on where this one ended, at the same ports. Machines that were found out stay expelled.
     *
     * @param more what it renders
     * @param following the options of this server, for that render
     */
    ServerRound follow(ServerJob more, ServerOptions following) throws IOException {
        more.expelledAlready(coordination.expelled());
        return start(following, log, coordination.secrets(), more);
    }

    /** The options of the round that comes after this one. */
    ServerOptions optionsOfNext() {
        return options.following(port(), statusPort());
    }

    ServerLog log() {
        return log;
    }

    int port() {
        return acceptor.port();
    }

    /** The port of the status page, or -1. */
    int statusPort() {
        return status == null ? -1 : status.port();
    }

    /** The hash of the certificate that a worker may pin; empty without TLS. */
    String pin() {
        return coordination.secrets().pin();
    }

    /** Work of the waiting thread, done now and then while workers render. */
    @FunctionalInterface
    interface Chore {
        void run() throws IOException;
    }

    /**
     * Renders until all is done, it is cancelled or ended; leaves the server open.
     *
     * @param chore done a few times a second on the calling thread, and once when it is over
     */
    void await(RenderProgress progress, BooleanSupplier cancelled, Chore chore) throws IOException {
        long told = -1;
        while (!coordination.isOver() && !cancelled.getAsBoolean()) {
            coordination.awaitEnd(TICK_MILLIS);
            long done = job.film().pixelsDone();
            if (done != told) {
                told = done;
                progress.progress(done, job.film().pixels(), job.film()::image);
            }
            chore.run();
        }
        Throwable failure = coordination.failure();
        if (failure != null) {
            end(false);
            String why = failure instanceof InvalidValueException e ? e.problem() : FileFailure.told(failure);
            throw new IOException("rendering failed here: " + why, failure);
        }
        chore.run();
    }

    private void tickAll() {
        try {
            while (!acceptor.isClosed()) {
                Thread.sleep(TICK_MILLIS);
                try {
                    tick();
                } catch (OutOfMemoryError e) {
                    // The next tick comes in any case, when there may be memory again.
                    log.seldom("memory", "out of memory for a moment: " + e.getMessage());
                }
            }
        } catch (InterruptedException e) {
            end(false);
        } catch (RuntimeException | Error e) {
            coordination.failed(e);
        }
    }

    private void tick() {
        long now = System.nanoTime();
        List<ServerConnection> all = connections.list();
        all.forEach(c -> c.check(now));
        log.tick();
        if (status != null) {
            status.check(now);
        }
        coordination.tick(now, all);
    }

    /** The job that is rendered. */
    ServerJob job() {
        return job;
    }

    void say(String line) {
        log.say(line);
    }

    /** The tiles of the job that two machines were to render. */
    List<Integer> auditsDue() {
        return coordination.auditsDue();
    }

    /** Tiles of {@link #auditsDue} that no second machine has rendered. */
    List<Integer> auditsMissing() {
        return coordination.auditsMissing();
    }

    /** The state of the render at this moment. */
    Snapshot snapshot() {
        return coordination.snapshot();
    }

    @Override
    public Status status() {
        return SnapshotStatus.of(snapshot());
    }

    @Override
    public Optional<Image> image() {
        return Optional.of(job.film().image());
    }

    @Override
    public State state() {
        return coordination.isFinished() ? State.FINISHED : State.RENDERING;
    }

    /** Ends this round, which another one may follow that the workers are to come to. Harmless if it has ended already. */
    void end(boolean continues) {
        if (!coordination.stop(continues)) {
            return;
        }
        // A connection still in its handshake receives the message at its end: before, a worker trusts no server.
        connections.list().stream().filter(ServerConnection::isKnown).forEach(c -> c.sayLast(coordination.lastWord()));
        coordination.stopLocal();
        connections.waitForFarewells();
        closeQuietly(acceptor);
        waitUntilNobodyListens();
        connections.closeAll();
        if (status != null) {
            closeQuietly(status::close);
        }
        closeQuietly(job);
    }

    /** Waits for the accepting thread, which holds the port: the caller may open another server there. */
    private void waitUntilNobodyListens() {
        if (accepting != null && accepting != Thread.currentThread()) {
            try {
                accepting.join(ACCEPT_END_TIMEOUT_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void closeQuietly(Closeable what) {
        try {
            what.close();
        } catch (IOException e) {
            log.say("while ending: " + e.getMessage());
        }
    }
}

package enlightenment.net;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.TiledRender;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.security.SecureRandom;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Renders one picture with the help of {@link RenderWorker}s, which may come, go and die as they please: the picture is that
 * of {@link enlightenment.render.Renderer}, bit for bit. docs/distributed.md tells how it is set up.
 */
public final class RenderServer implements Closeable {
    private static final long TICK_MILLIS = 200;
    private static final long LET_GO_MILLIS = 2_000;

    /** What workers are told where another render of the picture follows. */
    private static final String MORE = "the picture is rendered again with more samples";

    private final ServerOptions options;
    private final ServerJob job;
    private final Secrets secrets;
    private final Reception reception;
    private final Coordinator coordinator;
    private final StatusServer status;
    private final long started = System.nanoTime();
    private final Connections connections = new Connections();
    private final ServerLog log;
    private LocalWorker local;

    /** The thread that listens. */
    private Thread accepting;

    /** The servers that must follow this one, if there are any. */
    private final FollowingServers following = new FollowingServers(this);

    private boolean hasBegun;
    private volatile boolean isFinished;
    private boolean isClosed;
    private long lonelySince = System.nanoTime();
    private Throwable failure;

    private RenderServer(ServerOptions options, ServerLog log, Secrets secrets, ServerJob job) throws IOException {
        this.options = options;
        this.log = log;
        this.secrets = secrets;
        this.job = job;
        SecureRandom random = new SecureRandom();
        CoordinatorSettings settings = CoordinatorSettings.of(job.tiles(), random.nextLong(), random.nextLong())
                .withAuditRate(options.auditRate)
                .withSilence(options.timing.silenceMillis() * 1_000_000L);
        coordinator = new Coordinator(settings, job.restored(), System.nanoTime());
        try {
            reception = openReception();
            status = openStatus();
        } catch (IOException e) {
            job.close();
            throw e;
        }
    }

    private Reception openReception() throws IOException {
        try {
            return Reception.at(InetAddress.getByName(options.host), options.port, log);
        } catch (IOException e) {
            throw new IOException("cannot listen at " + options.host + ":" + options.port + ": " + e.getMessage(), e);
        }
    }

    private StatusServer openStatus() throws IOException {
        try {
            return options.statusPort < 0 ? null : StatusServer.start(this, options.statusPort);
        } catch (IOException e) {
            reception.close();
            throw new IOException("cannot show a status page at " + options.statusPort + ": " + e.getMessage(), e);
        }
    }

    /**
     * Plans the render and begins to listen; nothing is rendered before {@link #await}.
     *
     * @param cancelled asked now and then while the render is planned
     * @throws IOException if the server cannot listen, or a file of the options cannot be used
     * @throws IllegalArgumentException if options do not go together
     * @throws IllegalStateException if the library for CBOR, which is optional, is not there
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     */
    public static RenderServer start(
            Scene scene, RenderSettings settings, ServerOptions given, BooleanSupplier cancelled) throws IOException {
        CborLibrary.require();
        ServerLog log = new ServerLog(given.log, System::nanoTime);
        ServerOptions options = given.withLog(log::say);
        options.check();
        if (options.checkpoint.isPresent() && settings.budget().seconds().isPresent()) {
            throw new IllegalArgumentException(
                    "a budget of time is planned anew each time, so that a checkpoint would not fit: give samples");
        }
        // Before what takes long: these files may be of no use.
        Secrets secrets = Secrets.open(options);
        Canary.hash();
        TiledRender render = TiledRender.prepare(scene, settings, cancelled);
        render.notes().forEach(options.log);
        JobContent content = JobContent.of(scene, render.outline(), options.build);
        ServerJob job = new ServerJob(render, content, options.log);
        return begin(options, log, secrets, job, options.pardoned);
    }

    /** A server that goes on where another ended, with more samples. */
    static RenderServer follow(RenderServer before, ServerOptions options, TiledRender more) throws IOException {
        ServerJob next =
                before.job.with(more, options.build, before.coordinator.parts().expelled());
        return begin(options, before.log, before.secrets, next, List.of());
    }

    private static RenderServer begin(
            ServerOptions options, ServerLog log, Secrets secrets, ServerJob job, List<String> pardoned)
            throws IOException {
        if (options.checkpoint.isPresent()) {
            job.open(options.checkpointOfRound().orElseThrow(), pardoned);
        }
        RenderServer server = new RenderServer(options, log, secrets, job);
        Lobby lobby = new Lobby(server, server.connections, options.threads, log);
        server.accepting = lobby.startThread(() -> server.reception.accept(lobby::welcome, lobby::makeRoom), "accept");
        lobby.startThread(server::tickAll, "tick");
        return server;
    }

    /** The port that it listens at. */
    public int port() {
        return reception.port();
    }

    /** The port of the status page, or -1. */
    public int statusPort() {
        return status == null ? -1 : status.port();
    }

    /** What a worker may pin: the SHA-256 of the server's certificate in hexadecimal; empty without TLS. */
    public String pin() {
        return secrets.tls() == null ? "" : secrets.tls().certificate().toString();
    }

    /**
     * Renders until the picture is done, it is cancelled, or the calling thread is interrupted, and closes the server. An
     * interrupt stays set. Where an error was asked for and the picture is not as exact, it is rendered again with more samples,
     * by a server at the same port that the workers come to again.
     *
     * @param progress hears how it gets on, a few times a second, on the calling thread
     * @param cancelled asked a few times a second on the calling thread
     * @return the last picture that became whole; if not even the first did, what there is of it
     * @throws IOException if something in this process failed
     */
    public RenderResult await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        Interrupts stop = new Interrupts(cancelled);
        try {
            return following.await(progress, stop);
        } finally {
            stop.restore();
        }
    }

    /** Renders this server's own render, and leaves it open. */
    RenderResult awaitOne(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        long told = -1;
        while (!isOver() && !cancelled.getAsBoolean()) {
            synchronized (this) {
                pause(TICK_MILLIS);
            }
            long done = job.film().pixelsDone();
            if (done != told) {
                told = done;
                progress.progress(done, job.film().pixels(), job.film()::image);
            }
        }
        Throwable failed;
        synchronized (this) {
            failed = failure;
        }
        if (failed != null) {
            close();
            throw new IOException("rendering failed here: " + failed, failed);
        }
        return job.film().result();
    }

    private synchronized boolean isOver() {
        return isFinished || isClosed || failure != null;
    }

    private void pause(long millis) {
        try {
            wait(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    synchronized boolean admit(ServerConnection connection) {
        return !isClosed && connections.admit(connection);
    }

    /** A worker has all that it needs. */
    synchronized void ready(ServerConnection connection) {
        if (!connections.addWaiting(connection)) {
            return;
        }
        connection.tell(connection + " joined");
        if (hasBegun || connections.waiting() >= options.minWorkers) {
            begin();
        }
    }

    /** Begins whoever is missing. */
    synchronized void beginNow() {
        begin();
    }

    private void begin() {
        if (!hasBegun) {
            hasBegun = true;
            if (options.localThreads > 0) {
                startLocal(options.localThreads);
            }
        }
        connections.takeWaiting().forEach(c -> handle(c.joined()));
    }

    private void startLocal(int threads) {
        if (local == null) {
            local = new LocalWorker(this, threads);
            local.start();
        }
    }

    /** Something in this process went wrong: the render ends. */
    synchronized void failed(Throwable thrown) {
        failure = thrown;
        notifyAll();
    }

    /** Tells the coordinator, and does what it says. */
    synchronized void handle(Event event) {
        if (isClosed) {
            return;
        }
        for (Action action : coordinator.handle(System.nanoTime(), event)) {
            if (!job.keep(action)) {
                perform(action);
            }
        }
    }

    private void perform(Action action) {
        if (action instanceof Action.Grant a) {
            toWorker(a.worker(), new Message.Grant(a.lease(), job.hash(), a.first(), a.last()));
        } else if (action instanceof Action.Cancel a) {
            toWorker(a.worker(), new Message.Cancel(a.lease()));
        } else if (action instanceof Action.Skip a) {
            toWorker(a.worker(), new Message.Skip(a.lease(), a.first(), a.last()));
        } else if (action instanceof Action.Answer a) {
            toWorker(a.worker(), new Message.Alive(a.done(), job.tiles()));
        } else if (action instanceof Action.Acknowledge a) {
            toWorker(a.worker(), new Message.Acknowledge(a.tile()));
        } else if (action instanceof Action.HangUp a) {
            refuse(a.worker(), a.reason(), true);
        } else if (action instanceof Action.Refuse a) {
            refuse(a.worker(), a.reason(), false);
        } else if (action instanceof Action.CallLocal) {
            startLocal(Math.max(options.localThreads, 1));
        } else if (action instanceof Action.Finish) {
            isFinished = true;
            notifyAll();
        }
    }

    private void refuse(long worker, String reason, boolean again) {
        ServerConnection connection = connections.get(worker);
        if (connection != null) {
            connection.refuse(reason, again);
        }
    }

    private void toWorker(long worker, Message message) {
        if (worker == LocalWorker.ID) {
            local.hear(message);
            return;
        }
        ServerConnection connection = connections.get(worker);
        if (connection != null) {
            connection.send(message);
        }
    }

    /** A connection has ended. */
    void ended(ServerConnection connection, String reason) {
        synchronized (this) {
            connections.remove(connection);
        }
        if (connection.isJoined()) {
            handle(new Event.Left(connection.id(), reason));
        }
        if (!reason.isEmpty()) {
            connection.tell(connection + " left: " + reason);
        }
    }

    private void tickAll() {
        try {
            while (!reception.isClosed()) {
                Thread.sleep(TICK_MILLIS);
                try {
                    tick();
                } catch (OutOfMemoryError e) {
                    // The next tick comes in any case, when there may be memory again.
                    log.seldom("memory", "out of memory for a moment: " + e.getMessage());
                }
            }
        } catch (InterruptedException e) {
            close();
        } catch (RuntimeException | Error e) {
            failed(e);
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
        synchronized (this) {
            job.tick();
            boolean waited = (now - started) / 1e9 >= options.waitSeconds;
            if (!hasBegun && (options.minWorkers == 0 || waited)) {
                begin();
            }
            if (all.stream().anyMatch(ServerConnection::isJoined)) {
                lonelySince = now;
            } else if (hasBegun && (now - lonelySince) / 1e9 >= options.waitSeconds) {
                startLocal(Math.max(options.localThreads, Runtime.getRuntime().availableProcessors()));
            }
            if (local != null) {
                local.beat();
            }
            handle(new Event.Tick());
        }
    }

    /** How far it is. */
    synchronized Snapshot snapshot() {
        return coordinator.snapshot(System.nanoTime());
    }

    synchronized boolean isClosed() {
        return isClosed;
    }

    /** Whether all is done; asked without waiting for anything. */
    boolean isFinished() {
        return isFinished;
    }

    ServerLog log() {
        return log;
    }

    ServerJob job() {
        return job;
    }

    ServerOptions options() {
        return options;
    }

    Secrets secrets() {
        return secrets;
    }

    /** Ends the server: workers are told why, the checkpoint is kept. Harmless if it has ended already. */
    @Override
    public void close() {
        following.stop();
        end(false);
    }

    /** Ends this server, which another one may follow that the workers are to come to. */
    void end(boolean goesOn) {
        Message last;
        synchronized (this) {
            if (isClosed) {
                return;
            }
            isClosed = true;
            notifyAll();
            last = !isFinished
                    ? new Message.Refuse("the server was stopped", true)
                    : goesOn ? new Message.Refuse(MORE, true) : new Message.Bye("the picture is done");
        }
        connections.list().forEach(c -> c.sayLast(last));
        if (local != null) {
            local.close();
        }
        connections.waitForFarewells();
        closeQuietly(reception);
        waitUntilNobodyListens();
        if (status != null) {
            closeQuietly(status::close);
        }
        closeQuietly(job);
    }

    /** Its thread holds the port until it has noticed: whoever closes a server may open another one there. */
    private void waitUntilNobodyListens() {
        if (accepting != null && accepting != Thread.currentThread()) {
            try {
                accepting.join(LET_GO_MILLIS);
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

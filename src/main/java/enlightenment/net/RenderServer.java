package enlightenment.net;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.TiledRender;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.Closeable;
import java.io.IOException;
import java.net.Socket;
import java.security.SecureRandom;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Renders one picture with the help of {@link RenderWorker}s, which may come, go and die as they please: the picture is that
 * of {@link enlightenment.render.Renderer}, bit for bit. docs/distributed.md tells how it is set up.
 */
public final class RenderServer implements Closeable {
    private static final long TICK_MILLIS = 200;

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
    private LocalWorker local;

    /** The servers that must follow this one, if there are any. */
    private final FollowingServers following = new FollowingServers(this);

    private boolean hasBegun;
    private boolean isFinished;
    private boolean isClosed;
    private long lonelySince = System.nanoTime();
    private Throwable failure;

    private RenderServer(ServerOptions options, Secrets secrets, ServerJob job) throws IOException {
        this.options = options;
        this.secrets = secrets;
        this.job = job;
        if (options.checkpoint.isPresent()) {
            job.open(options.checkpointOfRound().orElseThrow());
        }
        CoordinatorSettings settings = CoordinatorSettings.of(job.tiles(), new SecureRandom().nextLong(), job.hash())
                .withAuditRate(options.auditRate)
                .withSilence(options.timing.silenceMillis() * 1_000_000L);
        coordinator = new Coordinator(settings, job.restored(), System.nanoTime());
        try {
            reception = new Reception(options.host, options.port, options.log);
            status = openStatus();
        } catch (IOException e) {
            job.close();
            throw e;
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
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     */
    public static RenderServer start(
            Scene scene, RenderSettings settings, ServerOptions options, BooleanSupplier cancelled) throws IOException {
        options.check();
        if (options.checkpoint.isPresent() && settings.budget().seconds().isPresent()) {
            throw new IllegalArgumentException(
                    "a budget of time is planned anew each time, so that a checkpoint would not fit: give samples");
        }
        // Before what takes long: these files may be of no use.
        Secrets secrets = Secrets.open(options);
        Canary.hash();
        TiledRender render = TiledRender.prepare(scene, settings, cancelled);
        JobContent content = JobContent.of(scene, settings, render.plan(), options.build);
        render.notes().forEach(options.log);
        return begin(new RenderServer(options, secrets, new ServerJob(render, content, options.log)));
    }

    /** A server that goes on where another ended, with more samples. */
    static RenderServer follow(RenderServer before, ServerOptions options, TiledRender more) throws IOException {
        ServerJob next =
                before.job.with(more, options.build, before.coordinator.parts().expelled());
        return begin(new RenderServer(options, before.secrets, next));
    }

    private static RenderServer begin(RenderServer server) {
        Reception.startThread(() -> server.reception.accept(server::welcome), "accept");
        Reception.startThread(server::tickAll, "tick");
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
     * Renders until the picture is done or it is cancelled, and closes the server. Where an error was asked for and the picture is
     * not as exact, it is rendered again with more samples, by a server at the same port that the workers come to again.
     *
     * @param progress hears how it gets on, a few times a second
     * @return the last picture that became whole; if not even the first did, what there is of it
     * @throws IOException if something in this process failed
     */
    public RenderResult await(RenderProgress progress, BooleanSupplier cancelled) throws IOException {
        return following.await(progress, cancelled);
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
            isClosed = true;
            Thread.currentThread().interrupt();
        }
    }

    /** Null if there are too many that nobody knows. */
    private synchronized Runnable welcome(Socket plain) {
        if (isClosed) {
            return null;
        }
        ServerConnection connection = connections.add(this, plain);
        if (connection == null) {
            options.log.accept("a connection was refused: " + Limits.STRANGERS + " others have not said who they are");
            return null;
        }
        return connection::run;
    }

    synchronized boolean admit(ServerConnection connection) {
        return !isClosed && connections.admit(connection);
    }

    /** A worker has all that it needs. */
    synchronized void ready(ServerConnection connection) {
        if (!connections.addWaiting(connection)) {
            return;
        }
        options.log.accept(connection + " joined");
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
            options.log.accept(connection + " left: " + reason);
        }
    }

    private void tickAll() {
        try {
            while (!reception.isClosed()) {
                Thread.sleep(TICK_MILLIS);
                tick();
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
        if (status != null) {
            status.close();
        }
        closeQuietly(job);
    }

    private void closeQuietly(Closeable what) {
        try {
            what.close();
        } catch (IOException e) {
            options.log.accept("while ending: " + e.getMessage());
        }
    }
}

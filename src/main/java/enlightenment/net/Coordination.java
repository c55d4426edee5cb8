package enlightenment.net;

import enlightenment.checkpoint.Origin;
import enlightenment.device.share.DeviceShare;
import enlightenment.engine.UnitAssembly;
import enlightenment.listen.ServerLog;
import enlightenment.net.protocol.Message;
import enlightenment.net.protocol.Timing;
import enlightenment.net.schedule.Action;
import enlightenment.net.schedule.Coordinator;
import enlightenment.net.schedule.CoordinatorSettings;
import enlightenment.net.schedule.Event;
import enlightenment.net.schedule.Snapshot;
import enlightenment.net.secure.Secrets;
import enlightenment.net.server.Connections;
import enlightenment.net.server.LocalWorker;
import enlightenment.net.server.ServerConnection;
import enlightenment.net.server.ServerJob;
import java.io.UncheckedIOException;
import java.security.SecureRandom;
import java.util.List;
import java.util.Set;

/**
 * The coordinator among threads: gives it a clock and a lock, and has what it decides done by the connections and the
 * server's own threads. For use by several threads at once.
 */
final class Coordination implements ServerConnection.Host {
    private static final double NANOS = 1e9;

    /** Reason of the {@link Message.Refuse} that workers receive where another round follows. */
    private static final String MORE = "the picture is rendered again with more samples";

    private final ServerOptions options;
    private final ServerLog log;
    private final Secrets secrets;
    private final ServerJob job;
    private final Connections connections;
    private final Coordinator coordinator;
    private final long started = System.nanoTime();

    /** Since when no worker is connected. */
    private long aloneSince = started;

    private LocalWorker local;

    /** What renders beside the threads of this process; null for none. */
    private final DeviceShare device;

    /** Tiles before this one may be made. */
    private int offered;

    private boolean hasBegun;
    private volatile boolean isFinished;

    /** The message that ends each worker's session, once the server has ended; null until then. */
    private Message lastWord;

    private Throwable failure;

    Coordination(ServerOptions options, ServerLog log, Secrets secrets, ServerJob job, Connections connections) {
        this.options = options;
        this.log = log;
        this.secrets = secrets;
        this.job = job;
        this.connections = connections;
        offered = job.film().end();
        SecureRandom random = new SecureRandom();
        CoordinatorSettings settings = CoordinatorSettings.of(job.tiles(), random.nextLong(), random.nextLong())
                .withOffered(offered)
                .withAuditRate(options.auditRate)
                .withSilence(options.timing.silenceMillis() * 1_000_000L);
        device = DeviceShare.chosen(options.device, log::say);
        coordinator = new Coordinator(settings, job.restored(), System.nanoTime());
    }

    @Override
    public Secrets secrets() {
        return secrets;
    }

    @Override
    public Timing timing() {
        return options.timing;
    }

    @Override
    public String version() {
        return options.version;
    }

    @Override
    public ServerJob job() {
        return job;
    }

    @Override
    public ServerLog log() {
        return log;
    }

    @Override
    public double weight(String name, String address) {
        return options.weight(name, address);
    }

    @Override
    public synchronized Message lastWord() {
        return lastWord;
    }

    @Override
    public synchronized boolean admit(ServerConnection connection) {
        return lastWord == null && connections.admit(connection);
    }

    @Override
    public synchronized void ready(ServerConnection connection) {
        if (!connections.addWaiting(connection)) {
            return;
        }
        connection.tell(connection + " joined");
        if (hasBegun || connections.waiting() >= options.minWorkers) {
            begin();
        }
    }

    private void begin() {
        if (!hasBegun) {
            hasBegun = true;
            if (options.localThreads > 0 || device != null) {
                startLocal(options.localThreads);
            }
        }
        connections.takeWaiting().forEach(c -> handle(c.joined()));
    }

    private void startLocal(int threads) {
        if (local == null) {
            local = new LocalWorker(job.units(), threads, device, job::result, this::handle, this::failed);
            local.start();
        }
    }

    /** Ends the render because of a failure in this process. */
    synchronized void failed(Throwable thrown) {
        failure = thrown;
        notifyAll();
    }

    @Override
    public synchronized void handle(Event event) {
        if (lastWord != null) {
            return;
        }
        for (Action action : coordinator.handle(System.nanoTime(), event)) {
            if (!keep(action)) {
                perform(action);
            }
        }
        for (UnitAssembly.Range lost : job.film().takeLost()) {
            handle(new Event.Forgotten(lost.first(), lost.last()));
        }
        int end = job.film().end();
        if (end > offered) {
            offered = end;
            handle(new Event.Offered(end));
        }
    }

    private boolean keep(Action action) {
        try {
            return job.keep(action);
        } catch (UncheckedIOException | ArithmeticException e) {
            // What does not count cannot be taken out of the picture, or the picture cannot hold what it should.
            failed(e);
            return true;
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
            AuditCount audits = AuditCount.ofTiles(auditsDue(), auditsMissing());
            if (audits.missing() > 0) {
                log.say("warning: " + audits.sentence());
            }
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

    @Override
    public void ended(ServerConnection connection, String reason) {
        connections.remove(connection);
        if (connection.isJoined()) {
            handle(new Event.Left(connection.id(), reason));
        }
        if (!reason.isEmpty()) {
            connection.tell(connection + " left: " + reason);
        }
    }

    /** Time has passed: begins without the workers that have not come, and renders here where none is left. */
    synchronized void tick(long now, List<ServerConnection> connected) {
        job.tick();
        boolean waited = (now - started) / NANOS >= options.waitSeconds;
        if (!hasBegun && (options.minWorkers == 0 || waited)) {
            begin();
        }
        if (connected.stream().anyMatch(ServerConnection::isJoined)) {
            aloneSince = now;
        } else if (hasBegun && (now - aloneSince) / NANOS >= options.waitSeconds) {
            startLocal(Math.max(options.localThreads, Runtime.getRuntime().availableProcessors()));
        }
        if (local != null) {
            local.beat();
        }
        handle(new Event.Tick());
    }

    /** Waits until it is over, but no longer than this; an interrupt ends the wait and stays set. */
    synchronized void awaitEnd(long millis) {
        if (isOver()) {
            return;
        }
        try {
            wait(millis);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Whether the picture is done, or will not be done here. */
    synchronized boolean isOver() {
        return isFinished || lastWord != null || failure != null;
    }

    /** The failure in this process that ended the render; null without one. */
    synchronized Throwable failure() {
        return failure;
    }

    /** Whether all is done; answered without waiting for anything. */
    boolean isFinished() {
        return isFinished;
    }

    /** The state of the render at this moment. */
    synchronized Snapshot snapshot() {
        return coordinator.snapshot(System.nanoTime());
    }

    /** The tiles that two were to render. */
    synchronized List<Integer> auditsDue() {
        return coordinator.auditsDue();
    }

    /** Tiles of {@link #auditsDue} that no second machine has rendered. */
    synchronized List<Integer> auditsMissing() {
        return coordinator.auditsMissing();
    }

    /** The machines whose results are not trusted any more. */
    synchronized Set<Origin.Peer> expelled() {
        return coordinator.expelled();
    }

    /**
     * Decides nothing from now on; false if that was so already.
     *
     * @param continues whether another render follows where this one is finished
     */
    synchronized boolean stop(boolean continues) {
        if (lastWord != null) {
            return false;
        }
        lastWord = !isFinished
                ? new Message.Refuse("the server was stopped", true)
                : continues ? new Message.Refuse(MORE, true) : new Message.Bye("the picture is done");
        notifyAll();
        return true;
    }

    /** Ends this process's own rendering. */
    void stopLocal() {
        LocalWorker mine;
        synchronized (this) {
            mine = local;
        }
        if (mine != null) {
            mine.close();
        }
        if (device != null) {
            device.note();
            device.close();
        }
    }
}

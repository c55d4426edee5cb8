package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import enlightenment.net.protocol.Limits;
import java.util.Optional;
import java.util.Set;

/** A worker process of the simulation around the real {@link WorkerCore}. */
final class SimWorker {
    private static final long STEP = SimWorld.SECOND / 2;
    private static final long SILENCE = 5 * SimWorld.SECOND;
    private static final long RESEND = 2 * SimWorld.SECOND;

    /** What it makes of tiles. */
    enum Honesty {
        HONEST,
        /** Wrong in a seventh of the tiles, always alike. */
        FLIPS_BITS,
        /** Wrong in all tiles, otherwise each time. */
        BABBLES
    }

    /** The server's own threads. */
    static final String LOCAL = "local";

    final String name;
    final int threads;
    final long tileNanos;
    final Honesty honesty;

    /** Takes tiles and sends heartbeats, but never finishes. */
    boolean stuck;

    boolean cutToServer;
    boolean cutToWorker;
    double slowness = 1;
    boolean frozen;

    private final SimWorld world;
    private final SimNetwork network;
    private final SimServer server;
    private WorkerCore core;
    private String key;
    private long connection;
    private long lastHeard;
    private int busy;

    /** Counts deaths, so that what a dead process had begun does not end. */
    private int life;

    private boolean dead = true;
    private boolean refused;

    SimWorker(
            SimWorld world, SimNetwork network, SimServer server, String name, int threads, long tileNanos, Honesty h) {
        this.world = world;
        this.network = network;
        this.server = server;
        this.name = name;
        this.threads = threads;
        this.tileNanos = tileNanos;
        honesty = h;
    }

    boolean isLocal() {
        return name.equals(LOCAL);
    }

    Origin origin() {
        return isLocal() ? Origin.SERVER : Peers.machine(name);
    }

    /** A new process. */
    void start() {
        if (!dead || refused) {
            return;
        }
        dead = false;
        frozen = false;
        life++;
        busy = 0;
        key = name + "#" + life;
        core = new WorkerCore(threads, Limits.UNACKNOWLEDGED_TILES, RESEND);
        connection = 0;
        int mine = life;
        world.in(world.between(0, STEP), () -> step(mine));
    }

    void die(boolean serverNotices) {
        if (dead) {
            return;
        }
        dead = true;
        long gone = connection;
        if (serverNotices && gone != 0) {
            network.send(this, true, () -> server.receive(new Event.Left(gone, "connection reset")));
        }
    }

    private void step(int mine) {
        if (dead || mine != life || refused) {
            return;
        }
        world.in(STEP, () -> step(mine));
        if (frozen) {
            return;
        }
        if (connection == 0 || world.now - lastHeard > SILENCE) {
            connect();
        } else {
            long to = connection;
            Set<Long> leases = Set.copyOf(core.leases());
            network.send(this, true, () -> server.receive(new Event.Heard(to, leases)));
        }
        pump();
    }

    private void connect() {
        core.disconnected();
        connection = server.newConnection();
        lastHeard = world.now;
        Event.Joined joined =
                isLocal() ? Peers.server(connection, threads) : Peers.joined(connection, key, name, threads, 1);
        network.send(this, true, () -> server.connect(this, joined));
    }

    private void pump() {
        for (Optional<WorkerCore.Task> t = next(); t.isPresent(); t = next()) {
            WorkerCore.Task task = t.get();
            busy++;
            int mine = life;
            if (!stuck) {
                long cost = (long) (tileNanos * slowness * (0.5 + world.random.nextDouble()));
                world.in(cost, () -> finish(mine, task));
            }
        }
        if (connection != 0) {
            for (WorkerCore.Outgoing out : core.outgoing(world.now)) {
                Event e = new Event.Delivered(connection, out.lease(), out.tile(), out.data());
                network.send(this, true, () -> server.receive(e));
            }
        }
    }

    private Optional<WorkerCore.Task> next() {
        return busy < threads ? core.begin() : Optional.empty();
    }

    private void finish(int mine, WorkerCore.Task task) {
        if (mine != life || dead) {
            return;
        }
        if (frozen) {
            world.in(STEP, () -> finish(mine, task));
            return;
        }
        busy--;
        core.finished(task, make(task.tile()));
        pump();
    }

    private SimTile make(int tile) {
        return switch (honesty) {
            case HONEST -> SimTile.right(tile);
            case FLIPS_BITS -> tile % 7 == 3 ? SimTile.wrong(tile, name.hashCode()) : SimTile.right(tile);
            case BABBLES -> SimTile.wrong(tile, world.random.nextLong());
        };
    }

    /** Something from the server arrives. */
    void receive(long from, Action action) {
        if (dead || from != connection) {
            return;
        }
        if (frozen) {
            // A stopped process finds its messages when it goes on.
            world.in(STEP, () -> receive(from, action));
            return;
        }
        lastHeard = world.now;
        if (action instanceof Action.Grant grant) {
            core.granted(grant.lease(), grant.first(), grant.last());
        } else if (action instanceof Action.Cancel cancel) {
            core.cancelled(cancel.lease());
        } else if (action instanceof Action.Skip skip) {
            core.skipped(skip.lease(), skip.first(), skip.last());
        } else if (action instanceof Action.Acknowledge ack) {
            core.acknowledged(ack.tile());
        } else if (action instanceof Action.HangUp) {
            connection = 0;
            core.disconnected();
        } else if (action instanceof Action.Refuse) {
            refused = true;
        }
        pump();
    }
}

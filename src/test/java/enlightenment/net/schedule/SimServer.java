package enlightenment.net.schedule;

import enlightenment.checkpoint.CheckpointJournal;
import enlightenment.checkpoint.JournalRecord;
import enlightenment.checkpoint.Origin;
import enlightenment.checkpoint.Restored;
import enlightenment.file.ContentHash;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** A server process of the simulation around the real {@link Coordinator}; watches that nothing is counted twice. */
final class SimServer {
    private static final long TICK = SimWorld.SECOND / 2;

    /** Heartbeats renew whatever their sender is believed to hold: the defect of the prototype. */
    boolean anonymousHeartbeats;

    boolean finished;
    int restarts;
    int expulsions;
    Snapshot atEnd;
    final Map<Integer, Made> picture = new HashMap<>();

    private final SimWorld world;
    private final SimNetwork network;
    private final CoordinatorSettings settings;
    private final List<Written> journal = new ArrayList<>();
    private final Map<Long, SimWorker> connected = new HashMap<>();
    private final Map<Long, List<Integer>> asked = new HashMap<>();
    private final Set<Long> used = new HashSet<>();
    private Coordinator coordinator;
    private Runnable onCallLocal = () -> {};
    private long connections;
    private int incarnation;

    SimServer(SimWorld world, SimNetwork network, CoordinatorSettings settings) {
        this.world = world;
        this.network = network;
        this.settings = settings;
    }

    /** A tile of the picture. */
    record Made(ContentHash hash, Origin origin, Origin second) {
        /** What is left without the word of a machine; what rests on it alone stays until it is revoked. */
        private Made without(Origin.Peer machine) {
            Restored.Tile left = new Restored.Tile(0, origin, hash, second).without(machine);
            return left == null ? this : new Made(hash, left.origin(), left.second());
        }
    }

    /** The tiles that a connection was ever asked for. */
    List<Integer> askedOf(long connection) {
        return asked.getOrDefault(connection, List.of());
    }

    private record Written(long time, Consumer<Restored.Builder> replay) {}

    void onCallLocal(Runnable call) {
        onCallLocal = call;
    }

    long newConnection() {
        return ++connections;
    }

    void start() {
        if (coordinator != null || finished) {
            return;
        }
        incarnation++;
        Restored.Builder builder = new Restored.Builder();
        journal.forEach(w -> w.replay.accept(builder));
        Restored restored = builder.build();
        picture.clear();
        for (Restored.Tile tile : restored.tiles()) {
            picture.put(tile.tile(), new Made(tile.hash(), tile.origin(), tile.second()));
        }
        CoordinatorSettings mine = new CoordinatorSettings(
                settings.tiles(),
                settings.offered(),
                settings.seed() + incarnation,
                settings.leaseNanos(),
                settings.silenceNanos(),
                settings.stallNanos(),
                settings.auditRate(),
                settings.auditSalt());
        coordinator = new Coordinator(mine, restored, world.now);
        int now = incarnation;
        tick(now);
    }

    /** kill -9, or the machine's power goes: then what was not forced to the disk is lost, too. */
    void die(boolean power) {
        if (coordinator == null || finished) {
            return;
        }
        restarts++;
        coordinator = null;
        connected.clear();
        if (power) {
            // A journal loses its end only: what follows a bad record is cut off.
            long forced = world.now - CheckpointJournal.FORCE_EVERY_NANOS;
            while (!journal.isEmpty() && last().time - forced > 0 && world.chance(0.7)) {
                journal.remove(journal.size() - 1);
            }
        }
    }

    private Written last() {
        return journal.get(journal.size() - 1);
    }

    private void tick(int mine) {
        if (mine == incarnation && coordinator != null && !finished) {
            receive(new Event.Tick());
            world.in(TICK, () -> tick(mine));
        }
    }

    /** A worker's connection arrives, perhaps twice. */
    void connect(SimWorker worker, Event.Joined joined) {
        if (coordinator != null && used.add(joined.worker())) {
            connected.put(joined.worker(), worker);
            receive(joined);
        }
    }

    void receive(Event event) {
        if (coordinator == null || finished) {
            return;
        }
        Event heard = event;
        if (anonymousHeartbeats && event instanceof Event.Heard h) {
            heard = new Event.Heard(h.worker(), coordinator.leasesOf(h.worker()));
        }
        for (Action action : coordinator.handle(world.now, heard)) {
            perform(action);
        }
    }

    private void perform(Action action) {
        if (action instanceof Action.Grant a) {
            for (int tile = a.first(); tile < a.last(); tile++) {
                asked.computeIfAbsent(a.worker(), w -> new ArrayList<>()).add(tile);
            }
            send(a.worker(), a);
        } else if (action instanceof Action.Cancel a) {
            send(a.worker(), a);
        } else if (action instanceof Action.Skip a) {
            send(a.worker(), a);
        } else if (action instanceof Action.Answer a) {
            send(a.worker(), a);
        } else if (action instanceof Action.Acknowledge a) {
            send(a.worker(), a);
        } else if (action instanceof Action.HangUp a) {
            send(a.worker(), a);
            connected.remove(a.worker());
        } else if (action instanceof Action.Refuse a) {
            send(a.worker(), a);
            connected.remove(a.worker());
        } else if (action instanceof Action.CallLocal) {
            onCallLocal.run();
        } else {
            record(action);
        }
    }

    private void send(long connection, Action action) {
        SimWorker worker = connected.get(connection);
        if (worker != null) {
            network.send(worker, false, () -> worker.receive(connection, action));
        }
    }

    private void record(Action action) {
        if (action instanceof Action.Keep a) {
            Made before = picture.put(a.tile(), new Made(a.data().hash(), a.origin(), null));
            if (before != null && before.hash.equals(a.data().hash())) {
                throw new AssertionError("tile " + a.tile() + " counted twice");
            }
            write(b -> b.kept(a.tile(), a.origin(), a.data().hash()));
        } else if (action instanceof Action.Confirm a) {
            Made made = picture.get(a.tile());
            picture.put(a.tile(), new Made(made.hash, made.origin, a.by()));
            write(b -> b.add(new JournalRecord.Confirmed(a.tile(), a.by(), made.hash)));
        } else if (action instanceof Action.Revoke a) {
            if (picture.remove(a.tile()) == null) {
                throw new AssertionError("tile " + a.tile() + " revoked, but nobody had made it");
            }
            write(b -> b.add(new JournalRecord.Revoked(a.tile())));
        } else if (action instanceof Action.Expel a) {
            expulsions++;
            picture.replaceAll((tile, made) -> made.without(a.machine()));
            write(b -> b.add(new JournalRecord.Expelled(a.machine())));
        } else if (action instanceof Action.Finish) {
            finished = true;
            atEnd = coordinator.snapshot(world.now);
        }
    }

    private void write(Consumer<Restored.Builder> replay) {
        journal.add(new Written(world.now, replay));
    }
}

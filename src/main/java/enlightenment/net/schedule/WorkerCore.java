package enlightenment.net.schedule;

import enlightenment.net.job.TileData;
import enlightenment.net.protocol.Limits;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The leases and results of a worker. Like the coordinator it has no clock, socket or thread; its caller serialises the calls.
 *
 * <p>Finished tiles wait in a box until the server has acknowledged them; at most a few travel unacknowledged, and where
 * the box fills up nothing new is begun. After a reconnection, also to another incarnation of the server, the box is sent
 * again; leases end with their connection.
 */
public final class WorkerCore {
    private final int threads;
    private final int window;
    private final long resendNanos;
    private final Map<Long, Held> leases = new LinkedHashMap<>();
    private final Map<Integer, Boxed> box = new LinkedHashMap<>();
    private final Set<Integer> inHand = new LinkedHashSet<>();

    /**
     * A worker without work.
     *
     * @param threads number of tiles that are rendered at once
     * @param window largest number of tiles that are sent and not acknowledged
     * @param resendNanos after so long without acknowledgement a tile is sent again; {@link Long#MAX_VALUE} for never,
     *     where the connection itself loses nothing
     */
    public WorkerCore(int threads, int window, long resendNanos) {
        this.threads = threads;
        this.window = window;
        this.resendNanos = resendNanos;
    }

    /** A tile to be rendered now. */
    public record Task(long lease, int tile) {}

    /** A lease: tiles not begun, and number of tiles begun or finished that the server has not acknowledged. */
    private static final class Held {
        final Deque<Integer> waiting = new ArrayDeque<>();
        final Set<Integer> begun = new LinkedHashSet<>();
    }

    /** A finished tile, and when it was sent; null if it was not. */
    private static final class Boxed {
        final long lease;
        final TileData data;
        Long sent;

        Boxed(long lease, TileData data) {
            this.lease = lease;
            this.data = data;
        }
    }

    /** A tile to be sent. */
    public record Outgoing(long lease, int tile, TileData data) {}

    public void granted(long lease, int first, int last) {
        if (leases.containsKey(lease) || leases.size() == Limits.LEASES_IN_HEARTBEAT) {
            return;
        }
        Held held = new Held();
        for (int tile = first; tile < last; tile++) {
            held.waiting.add(tile);
        }
        leases.put(lease, held);
    }

    public void cancelled(long lease) {
        Held held = leases.get(lease);
        if (held != null) {
            held.waiting.clear();
            forgetIfDone(lease, held);
        }
    }

    public void skipped(long lease, int first, int last) {
        Held held = leases.get(lease);
        if (held != null) {
            held.waiting.removeIf(tile -> tile >= first && tile < last);
            forgetIfDone(lease, held);
        }
    }

    private void forgetIfDone(long lease, Held held) {
        if (held.waiting.isEmpty() && held.begun.isEmpty()) {
            leases.remove(lease);
        }
    }

    /** The next tile to render; empty if there is none or too many wait to be sent or acknowledged. */
    public Optional<Task> begin() {
        if (box.size() >= window + threads) {
            return Optional.empty();
        }
        for (Map.Entry<Long, Held> entry : leases.entrySet()) {
            Held held = entry.getValue();
            for (Iterator<Integer> tiles = held.waiting.iterator(); tiles.hasNext(); ) {
                int tile = tiles.next();
                // A tile that came by two leases is not rendered twice.
                if (!inHand.contains(tile) && !box.containsKey(tile)) {
                    tiles.remove();
                    held.begun.add(tile);
                    inHand.add(tile);
                    return Optional.of(new Task(entry.getKey(), tile));
                }
            }
        }
        return Optional.empty();
    }

    /** The tile is rendered. */
    public void finished(Task task, TileData data) {
        inHand.remove(task.tile);
        box.put(task.tile, new Boxed(task.lease, data));
    }

    /** The tiles to send now, which are from then on unacknowledged. */
    public List<Outgoing> outgoing(long now) {
        List<Outgoing> list = new ArrayList<>();
        int travelling = 0;
        for (Map.Entry<Integer, Boxed> entry : box.entrySet()) {
            if (travelling == window) {
                break;
            }
            travelling++;
            Boxed boxed = entry.getValue();
            if (boxed.sent == null || now - boxed.sent >= resendNanos) {
                boxed.sent = now;
                list.add(new Outgoing(boxed.lease, entry.getKey(), boxed.data));
            }
        }
        return list;
    }

    /** The server has the tile; false if it waits in no box. */
    public boolean acknowledged(int tile) {
        Boxed boxed = box.remove(tile);
        if (boxed == null) {
            return false;
        }
        for (Map.Entry<Long, Held> entry : List.copyOf(leases.entrySet())) {
            entry.getValue().begun.remove(tile);
            entry.getValue().waiting.remove(tile);
            forgetIfDone(entry.getKey(), entry.getValue());
        }
        return true;
    }

    /** The leases to name in a heartbeat. */
    public List<Long> leases() {
        return List.copyOf(leases.keySet());
    }

    /** The connection is gone: its leases are over, finished tiles wait for the next one. */
    public void disconnected() {
        leases.clear();
        box.values().forEach(boxed -> boxed.sent = null);
    }

    /** Number of finished tiles that the server has not acknowledged. */
    int unacknowledged() {
        return box.size();
    }
}

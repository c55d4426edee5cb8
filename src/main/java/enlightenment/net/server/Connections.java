package enlightenment.net.server;

import enlightenment.listen.Strangers;
import enlightenment.machine.MachineFacts;
import enlightenment.net.protocol.Limits;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The connections of a server, their limits, and the workers that wait for the beginning. Its lock is not held while they act. Strangers
 * have places of their own ({@link Strangers}): they cannot take those of workers.
 */
public final class Connections {
    private static final long FAREWELL_TIMEOUT_MILLIS = 3_000;
    private static final long ROOM_TIMEOUT_MILLIS = 1_000;

    private final Map<Long, ServerConnection> workers = new LinkedHashMap<>();
    private final List<ServerConnection> waiting = new ArrayList<>();
    private final Strangers<ServerConnection> strangers;
    private final int places;

    /** Strangers that lost their places and whose threads have not ended yet. */
    private final Set<ServerConnection> leaving = new LinkedHashSet<>();

    private long made = LocalWorker.ID;

    public Connections() {
        places = Strangers.places(Limits.STRANGERS, MachineFacts.maxOpenFiles());
        strangers = new Strangers<>(places, Math.max(places / 2, 1));
    }

    /** The number of a new connection. */
    synchronized long newId() {
        return ++made;
    }

    /** Adds a connection that is not authenticated yet. Returns those that lost their places for it and are to be closed. */
    synchronized List<ServerConnection> add(ServerConnection connection) {
        List<ServerConnection> gone = strangers.add(connection, connection.address());
        leaving.addAll(gone);
        return gone;
    }

    /** The unauthenticated connection that is to be closed where room is needed; null if there is none. */
    synchronized ServerConnection giveUpOne() {
        ServerConnection oldest = strangers.oldest();
        if (oldest != null) {
            strangers.remove(oldest);
            leaving.add(oldest);
        }
        return oldest;
    }

    /** Waits until not more are leaving than may be there: who comes faster than others can go has to wait. */
    synchronized void waitForRoom() throws InterruptedException {
        long end = System.nanoTime() + ROOM_TIMEOUT_MILLIS * 1_000_000L;
        while (leaving.size() > places && end - System.nanoTime() > 0) {
            wait(ROOM_TIMEOUT_MILLIS / 10);
        }
    }

    /** Whether there is a place for a worker; then it is known from now on. */
    public synchronized boolean admit(ServerConnection connection) {
        if (workers.size() >= Limits.WORKERS || !strangers.contains(connection)) {
            return false;
        }
        strangers.remove(connection);
        workers.put(connection.id(), connection);
        connection.known();
        return true;
    }

    /** Puts a worker among those who wait for the beginning; false if it is there, or beyond. */
    public synchronized boolean addWaiting(ServerConnection connection) {
        return workers.containsKey(connection.id())
                && !connection.isJoined()
                && !waiting.contains(connection)
                && waiting.add(connection);
    }

    public synchronized int waiting() {
        return waiting.size();
    }

    /** The workers that waited for the beginning; none waits from now on. */
    public synchronized List<ServerConnection> takeWaiting() {
        List<ServerConnection> now = List.copyOf(waiting);
        waiting.clear();
        return now;
    }

    public synchronized void remove(ServerConnection connection) {
        strangers.remove(connection);
        workers.remove(connection.id());
        waiting.remove(connection);
        leaving.remove(connection);
        notifyAll();
    }

    /** The worker with this number; null if it has ended. */
    public synchronized ServerConnection get(long id) {
        return workers.get(id);
    }

    public synchronized List<ServerConnection> list() {
        List<ServerConnection> all = new ArrayList<>(workers.values());
        all.addAll(strangers.list());
        all.addAll(leaving);
        return all;
    }

    /** Waits up to three seconds until all connections have received the last message and ended. */
    public void waitForFarewells() {
        long deadline = System.nanoTime() + FAREWELL_TIMEOUT_MILLIS * 1_000_000L;
        while (!list().isEmpty() && System.nanoTime() - deadline < 0) {
            if (!sleep(10)) {
                return;
            }
        }
    }

    /** Ends what is left. */
    public void closeAll() {
        list().forEach(c -> c.close(""));
    }

    /** False if the thread was interrupted. */
    public static boolean sleep(long millis) {
        try {
            Thread.sleep(millis);
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}

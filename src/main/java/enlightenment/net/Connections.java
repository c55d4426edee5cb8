package enlightenment.net;

import java.net.Socket;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Who is connected to a server, how many may be, and who waits for the beginning. Its lock is held for none of what they do. */
final class Connections {
    private static final long FAREWELL_MILLIS = 3_000;

    private final Map<Long, ServerConnection> all = new LinkedHashMap<>();
    private final List<ServerConnection> waiting = new ArrayList<>();
    private long made = LocalWorker.ID;

    /** A connection of somebody whom nobody knows yet; null if there are too many of those. */
    synchronized ServerConnection add(RenderServer server, Socket plain) {
        if (count(false) >= Limits.STRANGERS) {
            return null;
        }
        ServerConnection connection = new ServerConnection(++made, server, plain);
        all.put(connection.id(), connection);
        return connection;
    }

    /** Whether there is a place for a worker; then it is known from now on. */
    synchronized boolean admit(ServerConnection connection) {
        if (count(true) >= Limits.WORKERS) {
            return false;
        }
        connection.known();
        return true;
    }

    private long count(boolean known) {
        return all.values().stream().filter(c -> c.isKnown() == known).count();
    }

    /** Puts a worker among those who wait for the beginning; false if it is there, or beyond. */
    synchronized boolean addWaiting(ServerConnection connection) {
        return !connection.isJoined() && !waiting.contains(connection) && waiting.add(connection);
    }

    synchronized int waiting() {
        return waiting.size();
    }

    /** Those who waited; nobody does from now on. */
    synchronized List<ServerConnection> takeWaiting() {
        List<ServerConnection> now = List.copyOf(waiting);
        waiting.clear();
        return now;
    }

    synchronized void remove(ServerConnection connection) {
        all.remove(connection.id());
        waiting.remove(connection);
    }

    /** Null if it has ended. */
    synchronized ServerConnection get(long id) {
        return all.get(id);
    }

    synchronized List<ServerConnection> list() {
        return List.copyOf(all.values());
    }

    /** Waits a little until everybody has heard the last word and gone. */
    void waitForFarewells() {
        long deadline = System.nanoTime() + FAREWELL_MILLIS * 1_000_000L;
        while (!list().isEmpty() && System.nanoTime() - deadline < 0) {
            if (!sleep(10)) {
                return;
            }
        }
    }

    /** False if the thread was interrupted. */
    static boolean sleep(long millis) {
        try {
            Thread.sleep(millis);
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}

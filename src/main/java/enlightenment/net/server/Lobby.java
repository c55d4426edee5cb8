package enlightenment.net.server;

import enlightenment.listen.ServerLog;
import java.net.Socket;
import java.util.concurrent.ThreadFactory;

/** Gives new connections a place and a thread. A connection that has to make room for them, or has no thread, is closed. */
public final class Lobby {
    private final ServerConnection.Host server;
    private final Connections connections;
    private final ThreadFactory threads;
    private final ServerLog log;

    public Lobby(ServerConnection.Host server, Connections connections, ThreadFactory threads, ServerLog log) {
        this.server = server;
        this.connections = connections;
        this.threads = threads;
        this.log = log;
    }

    public Thread startThread(Runnable work, String name) {
        Thread thread = threads.newThread(work);
        thread.setName("server " + name);
        thread.setDaemon(true);
        thread.start();
        return thread;
    }

    /** Starts a thread for a new connection. */
    public void welcome(Socket plain) {
        ServerConnection connection = new ServerConnection(connections.newId(), server, plain);
        try {
            connections.waitForRoom();
            connections.add(connection).forEach(c -> c.close("had to make room for newer ones, unknown like itself"));
            startThread(connection::run, "connection");
        } catch (OutOfMemoryError e) {
            turnAway(connection);
            makeRoom();
            log.seldom("threads", "no thread for " + connection + ": " + e.getMessage());
        } catch (InterruptedException e) {
            turnAway(connection);
            Thread.currentThread().interrupt();
        }
    }

    private void turnAway(ServerConnection connection) {
        connection.close("");
        connections.remove(connection);
    }

    /** Closes the unauthenticated connection that is the next to lose its place, if there is one. */
    public void makeRoom() {
        ServerConnection oldest = connections.giveUpOne();
        if (oldest != null) {
            oldest.close("had to make room: this process has not files or threads enough");
        }
    }
}

package enlightenment.listen;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.function.Consumer;

/** Accepts connections at a port. Out of file descriptors, it makes room, pauses, and continues. */
public final class Acceptor implements Closeable {
    static final long FIRST_PAUSE_MILLIS = 20;
    static final long LONGEST_PAUSE_MILLIS = 1_000;

    /** Source of connections. */
    interface Door extends Closeable {
        Socket accept() throws IOException;
    }

    /** A pause of the calling thread. */
    @FunctionalInterface
    interface Pause {
        void millis(long millis) throws InterruptedException;
    }

    private final Door door;
    private final int port;
    private final ServerLog log;
    private final Pause pause;
    private volatile boolean isClosed;

    Acceptor(Door door, int port, ServerLog log, Pause pause) {
        this.door = door;
        this.port = port;
        this.log = log;
        this.pause = pause;
    }

    /** Listens at an address; port 0 stands for any free one. */
    public static Acceptor at(InetAddress address, int port, ServerLog log) throws IOException {
        ServerSocket socket = new ServerSocket();
        try {
            socket.bind(new InetSocketAddress(address, port));
        } catch (IOException e) {
            socket.close();
            throw e;
        }
        Door door = new Door() {
            @Override
            public Socket accept() throws IOException {
                return socket.accept();
            }

            @Override
            public void close() throws IOException {
                socket.close();
            }
        };
        return new Acceptor(door, socket.getLocalPort(), log, Thread::sleep);
    }

    public int port() {
        return port;
    }

    public boolean isClosed() {
        return isClosed;
    }

    /**
     * Accepts connections until this is closed.
     *
     * @param welcome takes ownership of a connection
     * @param makeRoom closes the least important connection, which frees a file descriptor
     */
    public void accept(Consumer<Socket> welcome, Runnable makeRoom) {
        long millis = 0;
        while (!isClosed) {
            try {
                Socket plain = door.accept();
                if (millis > 0) {
                    log.seldom("accept", "connections are taken again");
                    millis = 0;
                }
                welcome.accept(plain);
            } catch (IOException | OutOfMemoryError e) {
                if (isClosed) {
                    return;
                }
                if (millis == 0) {
                    log.seldom("accept", "no connection can be taken for now: " + e.getMessage());
                }
                millis = Math.min(Math.max(2 * millis, FIRST_PAUSE_MILLIS), LONGEST_PAUSE_MILLIS);
                makeRoom.run();
                if (!pause(millis)) {
                    return;
                }
            }
        }
    }

    private boolean pause(long millis) {
        try {
            pause.millis(millis);
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    @Override
    public void close() throws IOException {
        isClosed = true;
        door.close();
    }
}

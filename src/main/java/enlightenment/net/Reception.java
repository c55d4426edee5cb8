package enlightenment.net;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.function.Consumer;
import java.util.function.Function;

/** Takes connections at a port, and gives each a thread. */
final class Reception implements Closeable {
    private final ServerSocket socket = new ServerSocket();
    private final Consumer<String> log;

    Reception(String host, int port, Consumer<String> log) throws IOException {
        this.log = log;
        try {
            socket.bind(new InetSocketAddress(InetAddress.getByName(host), port));
        } catch (IOException e) {
            socket.close();
            throw new IOException("cannot listen at " + host + ":" + port + ": " + e.getMessage(), e);
        }
    }

    int port() {
        return socket.getLocalPort();
    }

    boolean isClosed() {
        return socket.isClosed();
    }

    /**
     * Takes connections until it is closed.
     *
     * @param welcome gives what is to be done about a connection, or null if it is to be closed at once
     */
    void accept(Function<Socket, Runnable> welcome) {
        while (!socket.isClosed()) {
            try {
                Socket plain = socket.accept();
                Runnable work = welcome.apply(plain);
                if (work == null) {
                    plain.close();
                } else {
                    startThread(work, "connection");
                }
            } catch (IOException | OutOfMemoryError e) {
                // No more threads or files: those who are here go on.
                if (!socket.isClosed()) {
                    log.accept("a connection could not be taken: " + e.getMessage());
                }
            }
        }
    }

    static void startThread(Runnable work, String name) {
        Thread thread = new Thread(work, "server " + name);
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}

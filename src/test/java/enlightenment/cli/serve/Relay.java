package enlightenment.cli.serve;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Stands between workers and a server. Of what workers say it passes on so many bytes and loses the others, so that the picture
 * cannot be done, however fast the machine is, before the line is freed. Workers know its port, which it keeps while servers at any
 * port come and go.
 */
final class Relay implements AutoCloseable {
    private final ServerSocket door = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final List<Socket> sockets = new CopyOnWriteArrayList<>();
    private final AtomicLong left;
    private volatile int server;

    Relay(long bytes) throws IOException {
        left = new AtomicLong(bytes);
        start(this::accept);
    }

    int port() {
        return door.getLocalPort();
    }

    /** Where new connections lead to, from now on. */
    void leadTo(int port) {
        server = port;
    }

    /** From now on new connections are passed on whole. */
    void free() {
        left.set(Long.MAX_VALUE);
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "relay");
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!door.isClosed()) {
            Socket worker = null;
            try {
                worker = door.accept();
                sockets.add(worker);
                Socket behind = new Socket(InetAddress.getLoopbackAddress(), server);
                sockets.add(behind);
                Socket from = worker;
                start(() -> pass(from, behind, left));
                start(() -> pass(behind, from, new AtomicLong(Long.MAX_VALUE)));
            } catch (IOException e) {
                close(worker);
            }
        }
    }

    private static void pass(Socket from, Socket to, AtomicLong bytes) {
        byte[] buffer = new byte[4096];
        try {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            boolean isWhole = true;
            for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                isWhole &= bytes.getAndAdd(-n) >= n;
                // After a loss the rest would make no sense, even if the line is free by now.
                if (isWhole) {
                    out.write(buffer, 0, n);
                }
            }
        } catch (IOException e) {
            // The other end hears of it.
        } finally {
            close(from);
            close(to);
        }
    }

    private static void close(Socket socket) {
        try {
            if (socket != null) {
                socket.close();
            }
        } catch (IOException e) {
            // Then it is of no use anyway.
        }
    }

    @Override
    public void close() throws IOException {
        door.close();
        sockets.forEach(Relay::close);
    }
}

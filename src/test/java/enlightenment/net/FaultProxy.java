package enlightenment.net;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;

/** Stands between workers and a server, and passes on bytes: all, none, late or wrong, as it is told. */
final class FaultProxy implements Closeable {
    private final ServerSocket listening;
    private final int server;
    private final List<Socket> sockets = new ArrayList<>();
    private volatile long frozenUntil;
    private volatile int flips;
    private volatile boolean isSlow;

    FaultProxy(int server) throws IOException {
        this.server = server;
        listening = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start(this::accept);
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "proxy");
        thread.setDaemon(true);
        thread.start();
    }

    int port() {
        return listening.getLocalPort();
    }

    /** Resets all connections. */
    void cut() {
        List<Socket> all;
        synchronized (sockets) {
            all = List.copyOf(sockets);
            sockets.clear();
        }
        for (Socket socket : all) {
            try {
                socket.setSoLinger(true, 0);
                socket.close();
            } catch (IOException e) {
                continue;
            }
        }
    }

    /** Passes nothing on for so long. */
    void freeze(int millis) {
        frozenUntil = System.nanoTime() + millis * 1_000_000L;
    }

    /** Flips a bit in each of the next so many pieces. */
    void flip(int pieces) {
        flips = pieces;
    }

    /** Passes bytes on in small pieces, a few at a time. */
    void slow(boolean on) {
        isSlow = on;
    }

    /** How many have come that it did not cut off. */
    int connections() {
        synchronized (sockets) {
            return sockets.size() / 2;
        }
    }

    private void accept() {
        while (!listening.isClosed()) {
            try {
                Socket from = listening.accept();
                Socket to = new Socket(InetAddress.getLoopbackAddress(), server);
                synchronized (sockets) {
                    sockets.add(from);
                    sockets.add(to);
                }
                start(() -> pass(from, to));
                start(() -> pass(to, from));
            } catch (IOException e) {
                Farm.sleep(5);
            }
        }
    }

    private void pass(Socket from, Socket to) {
        byte[] buffer = new byte[4096];
        try (from;
                to;
                InputStream in = from.getInputStream();
                OutputStream out = to.getOutputStream()) {
            while (true) {
                int n = in.read(buffer, 0, isSlow ? 50 : buffer.length);
                if (n < 0) {
                    return;
                }
                while (System.nanoTime() - frozenUntil < 0) {
                    Farm.sleep(5);
                }
                if (flips > 0) {
                    flips--;
                    buffer[n / 2] ^= 1;
                }
                if (isSlow) {
                    Farm.sleep(1);
                }
                out.write(buffer, 0, n);
            }
        } catch (IOException e) {
            return;
        }
    }

    @Override
    public void close() throws IOException {
        listening.close();
        cut();
    }
}

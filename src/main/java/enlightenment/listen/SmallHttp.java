package enlightenment.listen;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.function.LongSupplier;

/**
 * HTTP/1.1 server (RFC 9112) for pages on one machine: requests without a body, one for each connection. Every connection has a deadline, and the
 * oldest is closed if there are too many, so that incomplete or numerous requests of one client do not block others. (The JDK's own server waits
 * for an incomplete request without limit, in one of few threads.)
 */
public final class SmallHttp implements Closeable {
    /** The most simultaneous connections. */
    public static final int PLACES = 32;

    static final int MAX_HEAD_BYTES = 8 << 10;
    /** The longest time for a request to arrive. */
    public static final long REQUEST_TIMEOUT_NANOS = 5_000_000_000L;
    /** The longest time from a request to the last byte of its answer, long answers aside. */
    public static final long ANSWER_TIMEOUT_NANOS = 20_000_000_000L;

    /** Additional time for each byte of an answer: 64 KiB in a second is a slow connection. */
    private static final long ANSWER_NANOS_PER_BYTE = 1_000_000_000L >> 16;

    /** Longest body that is sent together with its head. */
    private static final int SMALL_ANSWER_BYTES = 1 << 20;

    private static final int MAX_DRAINED_BYTES = 64 << 10;
    private static final int DRAIN_TIMEOUT_MILLIS = 200;

    private final Acceptor acceptor;
    private final Pages pages;
    private final ThreadFactory threads;
    private final ServerLog log;
    private final LongSupplier clock;
    private final Strangers<Socket> places = new Strangers<>(PLACES, PLACES);

    /** Deadline of each connection, in nanoseconds of the clock. */
    private final Map<Socket, Long> deadlines = new ConcurrentHashMap<>();

    private SmallHttp(Acceptor acceptor, Pages pages, ThreadFactory threads, ServerLog log, LongSupplier clock) {
        this.acceptor = acceptor;
        this.pages = pages;
        this.threads = threads;
        this.log = log;
        this.clock = clock;
    }

    /** A request; {@code host} is null unless the head has exactly one such field. */
    public record Request(String method, String path, String query, String host) {
        /**
         * Whether the request was sent to a name of loopback. This refuses pages elsewhere whose own name resolves to loopback (DNS rebinding).
         */
        public boolean isForLoopback() {
            return host != null && host.matches("(localhost|127(\\.\\d{1,3}){3}|\\[::1])(:\\d+)?");
        }

        /** The first value of a name in the query, not decoded; empty if there is none. Its length is bounded. */
        public Optional<String> value(String name) {
            for (String part : query.split("&")) {
                if (part.startsWith(name + "=")) {
                    return Optional.of(part.substring(name.length() + 1));
                }
            }
            return Optional.empty();
        }
    }

    /**
     * An answer to a request.
     *
     * @param code the HTTP status
     * @param type the media type of the body
     * @param body the content; not copied
     * @param sent called after the answer has been sent
     */
    public record Answer(int code, String type, byte[] body, Runnable sent) {
        public Answer(int code, String type, byte[] body) {
            this(code, type, body, () -> {});
        }

        public static Answer text(int code, String text) {
            return new Answer(code, "text/plain; charset=utf-8", text.getBytes(StandardCharsets.UTF_8));
        }

        /** A successful answer with JSON. */
        public static Answer json(String text) {
            return new Answer(200, "application/json", text.getBytes(StandardCharsets.UTF_8));
        }
    }

    /** Handler of requests; called by several threads at once. */
    @FunctionalInterface
    public interface Pages {
        Answer answer(Request request) throws IOException;
    }

    /**
     * Starts a server on loopback.
     *
     * @param port the port; 0 for any free one
     * @param clock nanoseconds of any origin, also of {@link #check}
     * @throws IOException if the port cannot be opened
     */
    public static SmallHttp start(int port, Pages pages, ThreadFactory threads, ServerLog log, LongSupplier clock)
            throws IOException {
        Acceptor acceptor = Acceptor.at(InetAddress.getLoopbackAddress(), port, log);
        SmallHttp http = new SmallHttp(acceptor, pages, threads, log, clock);
        http.startThread(() -> acceptor.accept(http::take, http::makeRoom));
        return http;
    }

    /** The port of the server. */
    public int port() {
        return acceptor.port();
    }

    private void startThread(Runnable work) {
        Thread thread = threads.newThread(work);
        thread.setName("status");
        thread.setDaemon(true);
        thread.start();
    }

    private void take(Socket socket) {
        List<Socket> gone;
        synchronized (places) {
            gone = places.add(socket, "");
        }
        gone.forEach(this::end);
        deadlines.put(socket, clock.getAsLong() + REQUEST_TIMEOUT_NANOS);
        try {
            startThread(() -> serve(socket));
        } catch (OutOfMemoryError e) {
            end(socket);
            log.seldom("threads", "no thread for a status request: " + e.getMessage());
        }
    }

    private void makeRoom() {
        Socket oldest;
        synchronized (places) {
            oldest = places.oldest();
        }
        if (oldest != null) {
            end(oldest);
        }
    }

    private void serve(Socket socket) {
        try {
            Request request = read(socket.getInputStream());
            deadlines.computeIfPresent(socket, (s, old) -> clock.getAsLong() + ANSWER_TIMEOUT_NANOS);
            Answer answer = request == null ? badRequest() : pages.answer(request);
            deadlines.computeIfPresent(socket, (s, old) -> old + answer.body.length * ANSWER_NANOS_PER_BYTE);
            write(socket.getOutputStream(), answer);
            socket.shutdownOutput();
            answer.sent.run();
            drain(socket);
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            // The client has left, or the answer cannot be made now: pages repeat their requests.
            end(socket);
        } finally {
            end(socket);
        }
    }

    private static Answer badRequest() {
        return Answer.text(400, "this is no request for a page\n");
    }

    /** Reads a request; null if it is malformed or too long. */
    private static Request read(InputStream in) throws IOException {
        StringBuilder head = new StringBuilder();
        while (head.indexOf("\r\n\r\n", Math.max(head.length() - 4, 0)) < 0) {
            int next = head.length() == MAX_HEAD_BYTES ? -1 : in.read();
            if (next < 0) {
                return null;
            }
            head.append((char) next);
        }
        String[] lines = head.toString().split("\r\n");
        String[] words = lines.length == 0 ? new String[0] : lines[0].split(" ", -1);
        if (words.length != 3 || !words[2].startsWith("HTTP/1.")) {
            return null;
        }
        String host = null;
        int hosts = 0;
        for (String line : lines) {
            int colon = line.indexOf(':');
            if (colon > 0 && line.substring(0, colon).equalsIgnoreCase("host")) {
                host = line.substring(colon + 1).strip();
                hosts++;
            }
        }
        int mark = words[1].indexOf('?');
        String path = mark < 0 ? words[1] : words[1].substring(0, mark);
        String query = mark < 0 ? "" : words[1].substring(mark + 1);
        return new Request(words[0], path, query, hosts == 1 ? host : null);
    }

    private static void write(OutputStream out, Answer answer) throws IOException {
        String head = "HTTP/1.1 " + answer.code + " " + (answer.code == 200 ? "OK" : "No") + "\r\nContent-Type: "
                + answer.type + "\r\nContent-Length: " + answer.body.length
                + "\r\nConnection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
                + "Cross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\n"
                + "Content-Security-Policy: default-src 'none'; img-src 'self'; connect-src 'self'; style-src 'self'; "
                + "script-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n\r\n";
        byte[] first = head.getBytes(StandardCharsets.US_ASCII);
        if (answer.body.length > SMALL_ANSWER_BYTES) {
            out.write(first);
            out.write(answer.body);
        } else {
            byte[] all = Arrays.copyOf(first, first.length + answer.body.length);
            System.arraycopy(answer.body, 0, all, first.length, answer.body.length);
            out.write(all);
        }
        out.flush();
    }

    /** Reads the rest of a request: unread bytes at the close may discard the answer on its way. */
    private static void drain(Socket socket) throws IOException {
        socket.setSoTimeout(DRAIN_TIMEOUT_MILLIS);
        byte[] buffer = new byte[4 << 10];
        for (int n = 0, sum = 0; n >= 0 && sum < MAX_DRAINED_BYTES; sum += n) {
            n = socket.getInputStream().read(buffer);
        }
    }

    public boolean isClosed() {
        return acceptor.isClosed();
    }

    /** Closes connections that have timed out; to be called regularly with the time of the clock. */
    public void check(long now) {
        deadlines.forEach((socket, deadline) -> {
            if (now - deadline > 0) {
                end(socket);
            }
        });
    }

    private void end(Socket socket) {
        synchronized (places) {
            places.remove(socket);
        }
        deadlines.remove(socket);
        try {
            socket.close();
        } catch (IOException e) {
            // A failed close needs no reaction: the socket is not used again.
            return;
        }
    }

    /** Closes the port and all connections. */
    @Override
    public void close() throws IOException {
        acceptor.close();
        deadlines.keySet().forEach(this::end);
    }
}

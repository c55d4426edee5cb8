package enlightenment.net;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** Shows how far a server is, on loopback, read-only: a page, the picture so far, JSON, and health for scripts. */
final class StatusServer {
    private static final int THREADS = 2;
    private static final int WAITING_REQUESTS = 32;
    private static final long PICTURE_EVERY_NANOS = 1_000_000_000L;

    private final RenderServer server;
    private final HttpServer http;
    private final ExecutorService executor;
    private final byte[] page;
    private final byte[] icon;
    private byte[] picture;
    private long pictureMade;

    private StatusServer(RenderServer server, int port) throws IOException {
        this.server = server;
        page = resource("status.html");
        icon = resource("icon.svg");
        http = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), WAITING_REQUESTS);
        // Who asks more than can be answered is turned away.
        executor = new ThreadPoolExecutor(
                THREADS, THREADS, 1, TimeUnit.MINUTES, new LinkedBlockingQueue<>(WAITING_REQUESTS), work -> {
                    Thread thread = new Thread(work, "status");
                    thread.setDaemon(true);
                    return thread;
                });
        http.setExecutor(executor);
        http.createContext("/", this::answer);
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = StatusServer.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    static StatusServer start(RenderServer server, int port) throws IOException {
        StatusServer status = new StatusServer(server, port);
        status.http.start();
        return status;
    }

    int port() {
        return http.getAddress().getPort();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            if (!isForUs(exchange)) {
                send(exchange, 403, "text/plain", "this page is for this machine only\n");
                return;
            }
            if (!exchange.getRequestMethod().equals("GET")) {
                send(exchange, 405, "text/plain", "only GET\n");
                return;
            }
            switch (exchange.getRequestURI().getPath()) {
                case "/":
                    send(exchange, 200, "text/html; charset=utf-8", page);
                    break;
                case "/icon.svg":
                    send(exchange, 200, "image/svg+xml", icon);
                    break;
                case "/status.json":
                    send(exchange, 200, "application/json", StatusJson.of(server.snapshot()));
                    break;
                case "/picture.png":
                    send(exchange, 200, "image/png", picture());
                    break;
                case "/health":
                    send(exchange, 200, "text/plain", server.snapshot().finished() ? "finished\n" : "rendering\n");
                    break;
                default:
                    send(exchange, 404, "text/plain", "there is /, /status.json, /picture.png and /health\n");
            }
        }
    }

    /** A page elsewhere that has a name of its own point here does not get an answer. */
    private static boolean isForUs(HttpExchange exchange) {
        String host = exchange.getRequestHeaders().getFirst("Host");
        return host != null && host.matches("(localhost|127(\\.\\d{1,3}){3}|\\[::1])(:\\d+)?");
    }

    private synchronized byte[] picture() throws IOException {
        long now = System.nanoTime();
        if (picture == null || now - pictureMade >= PICTURE_EVERY_NANOS) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageFiles.toPng(server.job().film().image(), out, PngOptions.DEFAULT);
            picture = out.toByteArray();
            pictureMade = now;
        }
        return picture;
    }

    private static void send(HttpExchange exchange, int code, String type, String text) throws IOException {
        send(exchange, code, type, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void send(HttpExchange exchange, int code, String type, byte[] body) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.getResponseHeaders().set("Cache-Control", "no-store");
        exchange.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
        exchange.getResponseHeaders()
                .set(
                        "Content-Security-Policy",
                        "default-src 'none'; img-src 'self'; connect-src 'self'; style-src 'unsafe-inline'; "
                                + "script-src 'unsafe-inline'; frame-ancestors 'none'");
        exchange.sendResponseHeaders(code, body.length);
        try (OutputStream out = exchange.getResponseBody()) {
            out.write(body);
        }
    }

    void close() {
        http.stop(0);
        executor.shutdownNow();
    }
}

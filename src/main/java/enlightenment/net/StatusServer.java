package enlightenment.net;

import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ThreadFactory;

/** Shows how far a server is, on loopback, read-only: a page, the picture so far, JSON, and health for scripts. */
final class StatusServer {
    private static final long PICTURE_EVERY_NANOS = 1_000_000_000L;

    private final RenderServer server;
    private final SmallHttp http;
    private final byte[] page;
    private final byte[] icon;
    private byte[] picture;
    private long pictureMade;

    private StatusServer(RenderServer server, int port, ThreadFactory threads) throws IOException {
        this.server = server;
        page = resource("status.html");
        icon = resource("icon.svg");
        http = SmallHttp.start(port, this::answer, threads, server.log());
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = StatusServer.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    static StatusServer start(RenderServer server, int port) throws IOException {
        return new StatusServer(server, port, server.options().threads);
    }

    int port() {
        return http.port();
    }

    /** Time has passed. */
    void check(long now) {
        http.check(now);
    }

    private SmallHttp.Answer answer(SmallHttp.Request request) throws IOException {
        if (!isForUs(request.host())) {
            return SmallHttp.Answer.text(403, "this page is for this machine only\n");
        }
        if (!request.method().equals("GET")) {
            return SmallHttp.Answer.text(405, "only GET\n");
        }
        switch (request.path()) {
            case "/":
                return new SmallHttp.Answer(200, "text/html; charset=utf-8", page);
            case "/icon.svg":
                return new SmallHttp.Answer(200, "image/svg+xml", icon);
            case "/status.json":
                byte[] json = StatusJson.of(server.snapshot()).getBytes(StandardCharsets.UTF_8);
                return new SmallHttp.Answer(200, "application/json", json);
            case "/picture.png":
                return new SmallHttp.Answer(200, "image/png", picture());
            case "/health":
                return SmallHttp.Answer.text(200, server.isFinished() ? "finished\n" : "rendering\n");
            default:
                return SmallHttp.Answer.text(404, "there is /, /status.json, /picture.png and /health\n");
        }
    }

    /** A page elsewhere that has a name of its own point here does not get an answer. */
    private static boolean isForUs(String host) {
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

    void close() throws IOException {
        http.close();
    }
}

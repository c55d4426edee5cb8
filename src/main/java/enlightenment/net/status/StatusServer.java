package enlightenment.net.status;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.net.listen.ServerLog;
import enlightenment.net.schedule.Snapshot;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ThreadFactory;
import java.util.function.LongSupplier;

/** Shows how far a server is, on loopback, read-only: a page, the picture so far, JSON, and health for scripts. */
public final class StatusServer {
    static final long PICTURE_PERIOD_NANOS = 1_000_000_000L;

    private final Source source;
    private final LongSupplier clock;
    private final SmallHttp http;
    private final byte[] page;
    private final byte[] icon;
    private byte[] picture;
    private long pictureMade;

    /** What is shown. For use by several threads at once. */
    public interface Source {
        /** How far it is. */
        Snapshot snapshot();

        /** The picture so far. */
        Image image();

        /** Whether all is done; answered without waiting for anything. */
        boolean isFinished();
    }

    private StatusServer(Source source, int port, ThreadFactory threads, ServerLog log, LongSupplier clock)
            throws IOException {
        this.source = source;
        this.clock = clock;
        page = resource("status.html");
        icon = resource("icon.svg");
        http = SmallHttp.start(port, this::answer, threads, log, clock);
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = StatusServer.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    /**
     * Begins to answer.
     *
     * @param port 0 for any that is free
     * @param clock nanoseconds of any origin, that of {@link #check} too
     * @throws IOException if it cannot listen there
     */
    public static StatusServer start(Source source, int port, ThreadFactory threads, ServerLog log, LongSupplier clock)
            throws IOException {
        return new StatusServer(source, port, threads, log, clock);
    }

    public int port() {
        return http.port();
    }

    /** Time has passed. */
    public void check(long now) {
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
                byte[] json = StatusJson.of(source.snapshot()).getBytes(StandardCharsets.UTF_8);
                return new SmallHttp.Answer(200, "application/json", json);
            case "/picture.png":
                return new SmallHttp.Answer(200, "image/png", picture());
            case "/health":
                return SmallHttp.Answer.text(200, source.isFinished() ? "finished\n" : "rendering\n");
            default:
                return SmallHttp.Answer.text(404, "there is /, /status.json, /picture.png and /health\n");
        }
    }

    /** A page elsewhere that has a name of its own point here does not get an answer. */
    private static boolean isForUs(String host) {
        return host != null && host.matches("(localhost|127(\\.\\d{1,3}){3}|\\[::1])(:\\d+)?");
    }

    private synchronized byte[] picture() throws IOException {
        long now = clock.getAsLong();
        if (picture == null || now - pictureMade >= PICTURE_PERIOD_NANOS) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            ImageFiles.toPng(source.image(), out, PngOptions.DEFAULT);
            picture = out.toByteArray();
            pictureMade = now;
        }
        return picture;
    }

    public void close() throws IOException {
        http.close();
    }
}

package enlightenment.status;

import enlightenment.image.Image;
import enlightenment.listen.ServerLog;
import enlightenment.listen.SmallHttp;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import java.util.function.LongSupplier;

/** The read-only HTTP server of a render's status, on loopback. It has a page, the picture so far, JSON, and health for scripts. */
public final class StatusServer {
    static final long PICTURE_PERIOD_NANOS = 1_000_000_000L;

    /** The largest share of a processor for encoding pictures: large ones are encoded less often. */
    static final double SHARE = 0.02;

    private static final long TICK_MILLIS = 200;

    private final StatusSource source;
    private final LongSupplier clock;
    private final SmallHttp http;
    private final Watchers watchers = new Watchers();
    private final byte[] page;
    private final byte[] style;
    private final byte[] script;
    private final byte[] icon;
    private byte[] picture;
    private boolean isLastPicture;
    private long pictureMade;
    private long pictureTook = Long.MAX_VALUE;

    private StatusServer(StatusSource source, int port, ThreadFactory threads, ServerLog log, LongSupplier clock)
            throws IOException {
        this.source = source;
        this.clock = clock;
        page = resource("status.html");
        style = resource("status.css");
        script = resource("status.js");
        icon = resource("icon.svg");
        http = SmallHttp.start(port, this::answer, threads, log, clock);
    }

    private static byte[] resource(String name) throws IOException {
        try (InputStream in = StatusServer.class.getResourceAsStream(name)) {
            return in.readAllBytes();
        }
    }

    /**
     * Starts a server; the caller must call {@link #check} regularly.
     *
     * @param port the port on loopback; 0 for any free one
     * @param clock nanoseconds of any origin, also of {@link #check}
     * @throws IOException if the port cannot be opened
     */
    public static StatusServer start(
            StatusSource source, int port, ThreadFactory threads, ServerLog log, LongSupplier clock)
            throws IOException {
        return new StatusServer(source, port, threads, log, clock);
    }

    /**
     * Starts a server on daemon threads of its own.
     *
     * @param port the port on loopback; 0 for any free one
     * @throws IOException if the port cannot be opened
     */
    public static StatusServer start(StatusSource source, int port, ServerLog log) throws IOException {
        StatusServer server = start(source, port, Thread::new, log, System::nanoTime);
        Thread ticking = new Thread(server::tick, "status tick");
        ticking.setDaemon(true);
        ticking.start();
        return server;
    }

    private void tick() {
        try {
            while (!http.isClosed()) {
                Thread.sleep(TICK_MILLIS);
                check(clock.getAsLong());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    public int port() {
        return http.port();
    }

    /** Closes connections that have timed out; to be called regularly with the time of the clock. */
    public void check(long now) {
        http.check(now);
    }

    /**
     * Waits until all open pages have received the end of the render and its last picture.
     *
     * @param millis the longest wait
     * @return false if the wait was too short
     */
    public boolean awaitWatchers(long millis) {
        return watchers.await(clock.getAsLong(), millis);
    }

    private SmallHttp.Answer answer(SmallHttp.Request request) throws IOException {
        if (!request.isForLoopback()) {
            return SmallHttp.Answer.text(403, "this page is for this machine only\n");
        }
        if (!request.method().equals("GET")) {
            return SmallHttp.Answer.text(405, "only GET\n");
        }
        return switch (request.path()) {
            case "/" -> new SmallHttp.Answer(200, "text/html; charset=utf-8", page);
            case "/status.css" -> new SmallHttp.Answer(200, "text/css; charset=utf-8", style);
            case "/status.js" -> new SmallHttp.Answer(200, "text/javascript; charset=utf-8", script);
            case "/icon.svg" -> new SmallHttp.Answer(200, "image/svg+xml", icon);
            case "/status.json" -> status(request);
            case "/picture.png" -> picture(request);
            case "/health" -> SmallHttp.Answer.text(200, source.state().word() + "\n");
            default -> SmallHttp.Answer.text(404, "there is /, /status.json, /picture.png and /health\n");
        };
    }

    private SmallHttp.Answer status(SmallHttp.Request request) {
        Optional<String> watcher = request.value("page");
        // Registered before the answer is made: a page that reads "not over" is waited for if the render ends while the
        // answer is on its way.
        if (watcher.isPresent() && !source.state().isOver()) {
            watchers.told(watcher.get(), clock.getAsLong());
        }
        Status status = source.status();
        byte[] json = StatusJson.of(status).getBytes(StandardCharsets.UTF_8);
        return new SmallHttp.Answer(200, "application/json", json, () -> {
            // A page does not request a picture if there is none.
            if (status.state().isOver() && status.picture() == 0) {
                watcher.ifPresent(watchers::served);
            }
        });
    }

    private SmallHttp.Answer picture(SmallHttp.Request request) throws IOException {
        State state = source.state();
        boolean isLast = state.isOver();
        byte[] png = picture(isLast);
        if (png == null) {
            return SmallHttp.Answer.text(404, "there is no picture yet\n");
        }
        // A request made before the end may arrive after it: its page has not received the end yet.
        boolean knowsEnd = isLast && request.value("state").equals(Optional.of(state.word()));
        return new SmallHttp.Answer(200, "image/png", png, () -> {
            if (knowsEnd) {
                request.value("page").ifPresent(watchers::served);
            }
        });
    }

    /** The picture as PNG, encoded anew if that is due; null if there is none. */
    private synchronized byte[] picture(boolean isLast) throws IOException {
        long now = clock.getAsLong();
        boolean isDue =
                picture == null || now - pictureMade >= Math.max(PICTURE_PERIOD_NANOS, (long) (pictureTook / SHARE));
        if (isDue || isLast && !isLastPicture) {
            Optional<Image> image = source.image();
            if (image.isEmpty()) {
                return null;
            }
            long start = System.nanoTime();
            picture = QuickPng.of(image.get());
            isLastPicture = isLast;
            pictureMade = now;
            // The shortest time of all: longer ones include waiting for a processor.
            pictureTook = Math.min(System.nanoTime() - start, pictureTook);
        }
        return picture;
    }

    public void close() throws IOException {
        http.close();
    }
}

package enlightenment.view;

import enlightenment.image.Image;
import enlightenment.image.ImageFormat;
import enlightenment.listen.ServerLog;
import enlightenment.listen.SmallHttp;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.SceneException;
import enlightenment.status.QuickPng;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Semaphore;

/**
 * The HTTP server of a view, on loopback. Page, style and script are open to all who can reach the port; state, picture and actions need the
 * key of the printed address, so that other users of the machine neither see nor change anything. Actions need a POST.
 */
final class ViewServer implements Closeable {
    /** The most pages that wait for news at the same time. */
    static final int MOST_VIEWERS = 8;

    /** The longest wait of a page for news: less than {@link SmallHttp#ANSWER_TIMEOUT_NANOS}. */
    private static final long PATIENCE_MILLIS = 8_000;

    private static final Map<String, String> TYPES = Map.of(
            "html", "text/html; charset=utf-8",
            "css", "text/css; charset=utf-8",
            "js", "text/javascript; charset=utf-8",
            "svg", "image/svg+xml");

    private final ViewSession session;
    private final SceneLoader loader;
    private final ViewActions actions;
    private final RenderPages renders;
    private final LookPages look;
    private final String title;
    private final byte[] key;
    private final SmallHttp http;
    private final Semaphore viewers = new Semaphore(MOST_VIEWERS);

    /** The last encoded picture, whose number is {@link #pngOf}; null if there is none. */
    private byte[] png;

    private long pngOf;

    /** @param key the access key that requests must carry */
    ViewServer(
            ViewSession session,
            SceneLoader loader,
            ViewActions actions,
            RenderPages renders,
            String title,
            String key,
            int port,
            ServerLog log)
            throws IOException {
        this.session = session;
        this.loader = loader;
        this.title = title;
        this.key = key.getBytes(StandardCharsets.UTF_8);
        this.actions = actions;
        this.renders = renders;
        look = new LookPages(session);
        http = SmallHttp.start(port, this::answer, Thread::new, log, System::nanoTime);
    }

    int port() {
        return http.port();
    }

    /** Closes connections that have timed out; to be called regularly. */
    void check() {
        http.check(System.nanoTime());
    }

    private SmallHttp.Answer answer(SmallHttp.Request request) throws IOException {
        if (!request.isForLoopback()) {
            return SmallHttp.Answer.text(403, "this page is for this machine only\n");
        }
        boolean isAction = request.path().equals("/do");
        if (!request.method().equals(isAction ? "POST" : "GET")) {
            return SmallHttp.Answer.text(405, isAction ? "only POST\n" : "only GET\n");
        }
        switch (request.path()) {
            case "/":
                return resource("view.html");
            case "/view.css", "/view.js", "/pointer.js", "/render.css", "/render.js", "/film.js", "/icon.svg":
            case "/look.css", "/layers.js", "/compare.js", "/convergence.js":
                return resource(request.path().substring(1));
            default:
                break;
        }
        if (!isKey(request.value("key").orElse(""))) {
            return SmallHttp.Answer.text(
                    403, "the key is missing or wrong: open the address that the command printed\n");
        }
        return answerToViewer(request);
    }

    private boolean isKey(String text) {
        return MessageDigest.isEqual(key, text.getBytes(StandardCharsets.UTF_8));
    }

    private static SmallHttp.Answer resource(String name) throws IOException {
        try (InputStream in = ViewServer.class.getResourceAsStream(name)) {
            String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
            return new SmallHttp.Answer(200, type, in.readAllBytes());
        }
    }

    private SmallHttp.Answer answerToViewer(SmallHttp.Request request) throws IOException {
        try {
            return switch (request.path()) {
                case "/state.json" -> state(request);
                case "/picture.png" -> picture();
                case "/pixel.json" -> pixel(request);
                case "/camera.json" -> SmallHttp.Answer.json(actions.camera());
                case "/do" -> action(request);
                case "/render.json" -> renders.status(request, PATIENCE_MILLIS);
                case "/render.png" -> renders.file(ImageFormat.PNG, "image/png");
                case "/render.exr" -> renders.file(ImageFormat.EXR, "image/x-exr");
                default -> look.answer(request);
            };
        } catch (BadParameter e) {
            return SmallHttp.Answer.text(400, e.getMessage() + "\n");
        } catch (InvalidValueException e) {
            return SmallHttp.Answer.text(409, "\"" + e.key() + "\" " + e.problem() + "\n");
        } catch (SceneException e) {
            return SmallHttp.Answer.text(409, String.join("\n", ViewSession.lines(e)) + "\n");
        } catch (SceneLoader.Refusal | CancellationException e) {
            return SmallHttp.Answer.text(409, e.getMessage() + "\n");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return SmallHttp.Answer.text(503, "the view has ended\n");
        }
    }

    private SmallHttp.Answer state(SmallHttp.Request request) throws InterruptedException {
        if (!viewers.tryAcquire()) {
            return SmallHttp.Answer.text(503, "there are " + MOST_VIEWERS + " pages already\n");
        }
        try {
            long after = request.value("after").isEmpty()
                    ? 0
                    : (long) ViewActions.number(request, "after", 0, Long.MAX_VALUE);
            look.wish(request);
            Snapshot now = session.awaitNewer(after, PATIENCE_MILLIS);
            return SmallHttp.Answer.json(ViewJson.state(now, title, loader.reasonAgainstSaving(now)));
        } finally {
            viewers.release();
        }
    }

    private SmallHttp.Answer picture() throws IOException {
        byte[] bytes = encoded();
        return bytes == null
                ? SmallHttp.Answer.text(404, "there is no picture yet\n")
                : new SmallHttp.Answer(200, "image/png", bytes);
    }

    /** The picture as PNG, or null. Synchronized, so that concurrent requests encode it once. */
    private synchronized byte[] encoded() throws IOException {
        Snapshot now = session.snapshot();
        Image image = now.shown();
        if (image != null && (png == null || pngOf != now.picture())) {
            png = QuickPng.of(image);
            pngOf = now.picture();
        }
        return png;
    }

    private SmallHttp.Answer pixel(SmallHttp.Request request) {
        double x = ViewActions.number(request, "x", 0, 1);
        double y = ViewActions.number(request, "y", 0, 1);
        PixelProbe pixel = actions.probe(x, y);
        Snapshot now = session.snapshot();
        return SmallHttp.Answer.json(ViewJson.pixel(pixel, now, x, y));
    }

    private SmallHttp.Answer action(SmallHttp.Request request) throws SceneLoader.Refusal {
        actions.act(request);
        return SmallHttp.Answer.json("{ \"version\": " + session.snapshot().version() + " }\n");
    }

    @Override
    public void close() throws IOException {
        http.close();
    }
}

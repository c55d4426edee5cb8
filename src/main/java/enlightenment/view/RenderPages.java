package enlightenment.view;

import enlightenment.image.ImageFormat;
import enlightenment.listen.SmallHttp;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import java.util.concurrent.Semaphore;

/** Answers requests for final renders: start, cancel, status and files. Thread-safe. */
final class RenderPages {
    private final ViewSession session;
    private final BackgroundRender render;
    private final int threads;
    private final Semaphore waiting = new Semaphore(ViewServer.MOST_VIEWERS);

    /** @param threads number of threads of a render */
    RenderPages(ViewSession session, BackgroundRender render, int threads) {
        this.session = session;
        this.render = render;
        this.threads = threads;
    }

    /**
     * Begins a render with the camera and exposure of the view.
     *
     * @throws BadParameter if a parameter of the request is invalid
     * @throws InvalidValueException if the scene cannot be rendered with these settings, or a render is under way
     */
    void start(SmallHttp.Request request) {
        ViewSession.Seen seen = session.seen();
        RenderSettings settings = RenderForm.settings(seen.scene(), request, threads);
        render.start(new RenderOrder(seen.scene(), seen.film(), seen.moment(), settings));
    }

    /** Cancels the render that is under way, if any. */
    void cancel() {
        render.cancel();
    }

    /**
     * Waits for a status newer than the page's, and returns it as JSON; 503 if too many pages wait.
     *
     * @param millis the longest wait
     */
    SmallHttp.Answer status(SmallHttp.Request request, long millis) throws InterruptedException {
        long after =
                request.value("after").isEmpty() ? 0 : (long) ViewActions.number(request, "after", 0, Long.MAX_VALUE);
        if (!waiting.tryAcquire()) {
            return SmallHttp.Answer.text(503, "there are " + ViewServer.MOST_VIEWERS + " pages already\n");
        }
        try {
            return SmallHttp.Answer.json(RenderJson.of(
                    render.awaitNewer(after, millis), session.snapshot().scene()));
        } finally {
            waiting.release();
        }
    }

    /** A file of the last render; 404 unless that render is done. */
    SmallHttp.Answer file(ImageFormat format, String type) {
        byte[] bytes = render.file(format);
        return bytes == null
                ? SmallHttp.Answer.text(404, "there is no finished render\n")
                : new SmallHttp.Answer(200, type, bytes);
    }
}

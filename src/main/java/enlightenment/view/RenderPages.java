package enlightenment.view;

import enlightenment.image.ImageFormat;
import enlightenment.listen.SmallHttp;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import java.util.concurrent.Semaphore;

/** What pages ask of final renders. */
final class RenderPages {
    private final ViewSession session;
    private final BackgroundRender render;
    private final int threads;
    private final Semaphore waiting = new Semaphore(ViewServer.MOST_VIEWERS);

    /** @param threads that share a render */
    RenderPages(ViewSession session, BackgroundRender render, int threads) {
        this.session = session;
        this.render = render;
        this.threads = threads;
    }

    /**
     * Begins a render of the scene as it is seen.
     *
     * @throws BadParameter if the request's words or numbers are none that it takes
     * @throws InvalidValueException if the scene cannot be rendered so, or a render is under way
     */
    void start(SmallHttp.Request request) {
        ViewSession.Seen seen = session.seen();
        RenderSettings settings = RenderForm.settings(seen.scene(), request, threads);
        render.start(new RenderOrder(seen.scene(), seen.film(), seen.moment(), settings));
    }

    /** Ends the render that is under way. */
    void cancel() {
        render.cancel();
    }

    /**
     * The answer to a page that waits for news.
     *
     * @param millis it waits at most so long
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

    /** A file of the last render. */
    SmallHttp.Answer file(ImageFormat format, String type) {
        byte[] bytes = render.file(format);
        return bytes == null
                ? SmallHttp.Answer.text(404, "there is no finished render\n")
                : new SmallHttp.Answer(200, type, bytes);
    }
}

package enlightenment.view;

import enlightenment.listen.ServerLog;
import java.io.Closeable;
import java.io.IOException;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Optional;

/** An interactive view of a scene file on a page on loopback. It is rendered anew whenever the camera or the file changes. */
public final class LiveView implements Closeable {
    private static final int KEY_BYTES = 16;
    private static final long WATCH_MILLIS = 300;
    private static final long TICK_MILLIS = 200;

    private final ViewSession session = new ViewSession();
    private final SceneLoader loader;
    private final String key;
    private final ViewServer server;

    /**
     * Settings of a view.
     *
     * @param title the title of the page
     * @param port the port on loopback; 0 for any free one
     * @param threads number of rendering threads, at least 1
     * @param samples samples per pixel of a finished picture, at least 1
     */
    public record Options(String title, int port, int threads, int samples) {}

    private LiveView(SceneSource source, PictureFiles files, Options options, ServerLog log) throws IOException {
        loader = new SceneLoader(source, session);
        if (options.threads() > 1) {
            start("view warm-up", new WarmUp());
        }
        loader.load();
        ScenePreparation preparation = new ScenePreparation();
        // The first picture takes longest: it is begun before anything else.
        start(
                "view render",
                new Refinement(session, preparation, source, options.threads(), options.samples(), System::nanoTime));
        byte[] bytes = new byte[KEY_BYTES];
        new SecureRandom().nextBytes(bytes);
        key = HexFormat.of().formatHex(bytes);
        RenderPages renders =
                new RenderPages(session, new BackgroundRender(session, files, System::nanoTime), options.threads());
        server = served(new ViewActions(session, loader, preparation, renders), renders, options, log);
        start("view layers", new LayerRefinement(session, preparation, source, options.threads()));
        start("view watch", () -> repeat(WATCH_MILLIS, loader::check));
        start("view tick", () -> repeat(TICK_MILLIS, server::check));
    }

    private ViewServer served(ViewActions actions, RenderPages renders, Options options, ServerLog log)
            throws IOException {
        try {
            return new ViewServer(session, loader, actions, renders, options.title(), key, options.port(), log);
        } catch (IOException e) {
            session.close();
            throw e;
        }
    }

    /**
     * Reads the scene, then renders and answers requests on daemon threads.
     *
     * @param files encodes final renders
     * @throws enlightenment.scene.SceneException if the scene cannot be read
     * @throws IOException if the port cannot be opened
     */
    public static LiveView start(SceneSource source, PictureFiles files, Options options, ServerLog log)
            throws IOException {
        return new LiveView(source, files, options, log);
    }

    private static void start(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    private void repeat(long millis, Runnable work) {
        try {
            while (!session.isClosed()) {
                Thread.sleep(millis);
                work.run();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** The address of the page, with the access key behind {@code #}: browsers do not send that part to servers. */
    public String address() {
        return "http://127.0.0.1:" + server.port() + "/#" + key;
    }

    /**
     * Writes camera and exposure into the scene file, if they differ from the file's.
     *
     * @return the reason in words if the file could not be written; else empty
     */
    public Optional<String> save() {
        try {
            if (session.snapshot().isMoved()) {
                loader.save();
            }
            return Optional.empty();
        } catch (SceneLoader.Refusal e) {
            return Optional.of(e.getMessage());
        }
    }

    /** Stops rendering and closes the server. */
    @Override
    public void close() throws IOException {
        session.close();
        server.close();
    }
}

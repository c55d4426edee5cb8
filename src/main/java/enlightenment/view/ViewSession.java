package enlightenment.view;

import enlightenment.math.InvalidValueException;
import enlightenment.render.Film;
import enlightenment.render.RenderResult;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import enlightenment.text.Plain;
import enlightenment.view.camera.Viewpoint;
import enlightenment.view.frame.Frame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.UnaryOperator;

/** The state of a view: scene, viewpoint, size, exposure, and the last picture. All members are thread-safe. */
final class ViewSession {
    private static final int BOX_WIDTH = 960;
    private static final int BOX_HEIGHT = 720;
    private static final int MOST_LINES = 20;
    private static final int LONGEST_LINE = 500;

    /** A view is in use for this long after a change that restarts its picture. */
    private static final long IN_USE_NANOS = 3_000_000_000L;

    /** The scene without its shutter instants, as motion blur would delay the first picture. Null until a file was read. */
    private Scene scene;

    /** The scene with all shutter instants; null until a file was read. */
    private Scene whole;

    /** The animation frame of the scene, counted from 0; empty if no track has been applied. */
    private OptionalInt moment = OptionalInt.empty();

    /** Images and material tables that are shared by the scene's pictures; null until a file was read. */
    private Film film;

    private Viewpoint viewpoint;
    private double exposure;
    private int boxWidth = BOX_WIDTH;
    private int boxHeight = BOX_HEIGHT;

    /** Number of changes that made pictures out of date. */
    private long generation;

    /** Number of changes of anything that a page shows. */
    private long version = 1;

    private Frame frame;

    /** Number of changes of the picture or layers that a page shows. */
    private long picture;

    /** Problems of the file, one in a line; empty if it could be read. */
    private List<String> problems = List.of();

    /** Problems of rendering the current generation, one in a line. */
    private List<String> failures = List.of();

    private String note = "";
    private boolean closed;

    /** Whether a final render is under way. */
    private boolean hasBackground;

    /** Time of the last change of {@link #generation}, as {@link System#nanoTime}. */
    private long restarted;

    /** Layers and the kept picture. */
    private final Looks looks = new Looks(new LayerWishes(System::nanoTime));

    /**
     * A scene with the camera and exposure of the view, and with motion blur.
     *
     * @param film images and material tables that are shared by the scene's pictures
     * @param moment the animation frame, counted from 0; empty if no track has been applied
     */
    record Seen(Scene scene, Film film, OptionalInt moment) {}

    /** The problems of a scene, one in a line, without control characters; number and length of lines are bounded. */
    static List<String> lines(SceneException e) {
        return e.problems().stream()
                .limit(MOST_LINES)
                .map(p -> Plain.line(p.toString(), LONGEST_LINE))
                .toList();
    }

    /**
     * Replaces the scene. The camera that the user has chosen stays, unless the file's camera has changed; so does the exposure.
     *
     * @param of images and material tables that are shared by the scene's pictures
     * @param frame the animation frame, counted from 0; empty if no track has been applied
     */
    synchronized void loaded(Scene read, Film of, OptionalInt frame) {
        boolean sameCamera = scene != null && scene.camera().equals(read.camera());
        boolean sameExposure = scene != null && scene.display().equals(read.display());
        if (!sameCamera) {
            viewpoint = Viewpoint.of(read.camera());
        }
        if (!sameExposure) {
            exposure = read.display().exposure();
            picture++;
        }
        scene = read.withInstants(List.of());
        whole = read;
        film = of;
        moment = frame;
        problems = List.of();
        note = "";
        restart();
    }

    /** Sets the problems of a file that could not be read; the last scene stays. */
    synchronized void broken(List<String> lines) {
        if (!problems.equals(lines)) {
            problems = List.copyOf(lines);
            changed();
        }
    }

    /**
     * Moves the camera.
     *
     * @throws InvalidValueException if the camera cannot make that motion, or no scene has been read yet
     */
    synchronized void move(UnaryOperator<Viewpoint> motion) {
        requireScene();
        Viewpoint moved = motion.apply(viewpoint);
        note = "";
        if (moved.camera().equals(viewpoint.camera())) {
            viewpoint = moved;
            return;
        }
        viewpoint = moved;
        restart();
    }

    /** Restores the camera and the exposure of the file. */
    synchronized void reset() {
        requireScene();
        viewpoint = Viewpoint.of(scene.camera());
        exposure = scene.display().exposure();
        picture++;
        note = "";
        restart();
    }

    /**
     * Sets the exposure: pictures are shown 2^stops times as bright.
     *
     * @throws InvalidValueException if the exposure is out of range, or pictures are display-referred
     */
    synchronized void expose(double stops) {
        requireScene();
        if (!(scene.shading() instanceof Shading.Physical)) {
            throw new InvalidValueException(
                    "exposure", "is for physical shading: this scene's colours are those of a screen");
        }
        new Scene.Display(stops, scene.display().tone());
        exposure = stops;
        picture++;
        note = "";
        changed();
    }

    /** Sets the box in pixels that the picture is fitted into, clamped to the limits of {@link ViewSize}. */
    synchronized void resize(int width, int height) {
        ViewSize before = size();
        boxWidth = width;
        boxHeight = height;
        if (before != null && !before.equals(size())) {
            restart();
        }
    }

    /** Sets the note that pages show about the last action. */
    synchronized void note(String text) {
        note = text;
        changed();
    }

    private void requireScene() {
        if (scene == null) {
            throw new InvalidValueException("scene", "could not be read yet");
        }
    }

    private ViewSize size() {
        return scene == null ? null : ViewSize.fitting(scene.width(), scene.height(), boxWidth, boxHeight);
    }

    private void restart() {
        generation++;
        restarted = System.nanoTime();
        failures = List.of();
        changed();
    }

    private void changed() {
        version++;
        notifyAll();
    }

    /** Whether a generation is the current one and the session is open. */
    synchronized boolean isCurrent(long which) {
        return which == generation && !closed;
    }

    /**
     * Waits for a scene of another generation than the one that is done.
     *
     * @param done the generation that needs no more rendering
     * @return the shot to render; null if the session was closed
     */
    synchronized Shot awaitShot(long done) throws InterruptedException {
        while (!closed && (scene == null || generation == done)) {
            wait();
        }
        return closed ? null : shot();
    }

    /** The shot of the current generation, without motion blur; fails if no scene has been read yet. */
    synchronized Shot shot() {
        requireScene();
        return new Shot(generation, Scenes.seenBy(scene, viewpoint.camera()), film, size());
    }

    /** The scene of a final render, with motion blur; fails if no scene has been read yet. */
    synchronized Seen seen() {
        requireScene();
        Scene.Display display = new Scene.Display(exposure, whole.display().tone());
        return new Seen(Scenes.seenAs(whole, viewpoint.camera(), display), film, moment);
    }

    /** Sets whether a final render is under way, which has the processors while the view is at rest. */
    synchronized void background(boolean isUnderWay) {
        hasBackground = isUnderWay;
        notifyAll();
    }

    /** Whether the picture was restarted within the last {@link #IN_USE_NANOS} nanoseconds. */
    synchronized boolean isInUse() {
        return System.nanoTime() - restarted < IN_USE_NANOS;
    }

    /** Waits while a final render is under way and the generation has a picture at full resolution. */
    synchronized void awaitProcessors(long which) throws InterruptedException {
        while (hasBackground
                && isCurrent(which)
                && frame != null
                && frame.generation() == which
                && frame.shrink() == 1) {
            wait();
        }
    }

    /** Replaces the picture, unless the new one is out of date. */
    synchronized void publish(Frame next) {
        if (isCurrent(next.generation())) {
            frame = next;
            picture++;
            changed();
        }
    }

    /** Sets the problems of rendering a generation, unless it is out of date. */
    synchronized void failed(long which, List<String> lines) {
        if (isCurrent(which)) {
            failures = List.copyOf(lines);
            changed();
        }
    }

    synchronized Snapshot snapshot() {
        boolean isMoved = scene != null
                && (!viewpoint.camera().equals(scene.camera())
                        || exposure != scene.display().exposure());
        List<String> all = new ArrayList<>(problems);
        all.addAll(failures);
        return new Snapshot(
                version,
                picture,
                frame,
                scene,
                viewpoint,
                size(),
                exposure,
                moment,
                all,
                note,
                isMoved,
                frame != null && frame.generation() == generation,
                looks.kept(),
                looks.layers());
    }

    /** Requests a layer that a page shows, and wakes the thread that renders layers. */
    synchronized void wish(Layer layer) {
        looks.wish(layer);
        notifyAll();
    }

    /** Withdraws all requests for layers, which cannot be rendered; open pages request theirs again. */
    synchronized void clearWishes() {
        looks.clearWishes();
    }

    /**
     * Waits until a layer is missing that a page has requested.
     *
     * @return the missing layers; null if the session was closed
     */
    synchronized LayerRefinement.Wish awaitWish() throws InterruptedException {
        while (!closed && (scene == null || looks.missing(generation).isEmpty())) {
            wait();
        }
        return closed ? null : new LayerRefinement.Wish(shot(), looks.missing(generation));
    }

    /** Replaces layers, unless the new ones are out of date. */
    synchronized void publish(long which, Map<RenderResult.Auxiliary, Layers.Numbers> next) {
        if (isCurrent(which)) {
            looks.add(next);
            picture++;
            changed();
        }
    }

    /**
     * Keeps the picture, as it is shown now, for comparison with later ones.
     *
     * @throws InvalidValueException if there is no picture yet
     */
    synchronized void keep() {
        if (frame == null) {
            throw new InvalidValueException("picture", "is not there yet");
        }
        looks.keep(frame, snapshot().shown());
        note = "";
        changed();
    }

    /** Discards the kept picture. */
    synchronized void forget() {
        looks.forget();
        note = "";
        changed();
    }

    /** The exposure of the view, in stops. */
    synchronized double exposure() {
        return exposure;
    }

    /**
     * Waits for a state newer than a version, and returns the latest state.
     *
     * @param millis the longest wait
     */
    synchronized Snapshot awaitNewer(long than, long millis) throws InterruptedException {
        long end = System.nanoTime() + millis * 1_000_000;
        long left = millis;
        while (!closed && version <= than && left > 0) {
            wait(left);
            left = (end - System.nanoTime()) / 1_000_000;
        }
        return snapshot();
    }

    synchronized boolean isClosed() {
        return closed;
    }

    synchronized void close() {
        closed = true;
        notifyAll();
    }
}

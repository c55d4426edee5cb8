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

/** What a view shows now: scene, viewpoint, size, exposure, and the last picture. All members are safe for several threads. */
final class ViewSession {
    private static final int BOX_WIDTH = 960;
    private static final int BOX_HEIGHT = 720;
    private static final int MOST_LINES = 20;
    private static final int LONGEST_LINE = 500;

    /** Motions so recent mean that the view is in use. */
    private static final long IN_USE_NANOS = 3_000_000_000L;

    /** A moment of the scene that was read: without motion blur it is there at once. Null until it could be read. */
    private Scene scene;

    /** The scene as it was read. */
    private Scene whole;

    /** The frame of its animation that it is; empty if it is as the file's own numbers say. */
    private OptionalInt moment = OptionalInt.empty();

    /** What its pictures have in common; null until there is a scene. */
    private Film film;

    private Viewpoint viewpoint;
    private double exposure;
    private int boxWidth = BOX_WIDTH;
    private int boxHeight = BOX_HEIGHT;

    /** Counts what makes pictures out of date. */
    private long generation;

    /** Counts everything that a page shows. */
    private long version = 1;

    private Frame frame;

    /** Counts what a page shows as its picture. */
    private long picture;

    /** What is wrong with the file. */
    private List<String> problems = List.of();

    /** Why the scene cannot be rendered as it is now. */
    private List<String> failures = List.of();

    private String note = "";
    private boolean closed;

    /** Whether a final render is under way. */
    private boolean hasBackground;

    /** When what is to be seen last changed. */
    private long restarted;

    /** What pages look at beside the picture. */
    private final Looks looks = new Looks(new LayerWishes(System::nanoTime));

    /**
     * The scene as it is seen now, with motion blur.
     *
     * @param film what its pictures have in common
     * @param moment the frame of its animation; empty if it is as its file's own numbers say
     */
    record Seen(Scene scene, Film film, OptionalInt moment) {}

    /** The problems of a scene, one in a line, made harmless. */
    static List<String> lines(SceneException e) {
        return e.problems().stream()
                .limit(MOST_LINES)
                .map(p -> Plain.line(p.toString(), LONGEST_LINE))
                .toList();
    }

    /**
     * Shows a scene that was read. The camera that the user has chosen stays, unless the file's camera has changed; so does the exposure.
     *
     * @param of what pictures of it have in common
     * @param frame of its animation; empty if it is as the file's own numbers say
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

    /** The file cannot be used as it is now. */
    synchronized void broken(List<String> lines) {
        if (!problems.equals(lines)) {
            problems = List.copyOf(lines);
            changed();
        }
    }

    /**
     * Moves the camera.
     *
     * @throws InvalidValueException if the camera cannot move so, or the scene could not be read yet
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

    /** Shows the camera and the exposure of the file again. */
    synchronized void reset() {
        requireScene();
        viewpoint = Viewpoint.of(scene.camera());
        exposure = scene.display().exposure();
        picture++;
        note = "";
        restart();
    }

    /**
     * Shows pictures 2^stops times as bright.
     *
     * @throws InvalidValueException if that is out of range, or pictures are display-referred
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

    /** The picture is to fit into a box of pixels; values beyond the limits of {@link ViewSize} are brought within them. */
    synchronized void resize(int width, int height) {
        ViewSize before = size();
        boxWidth = width;
        boxHeight = height;
        if (before != null && !before.equals(size())) {
            restart();
        }
    }

    /** Tells the pages of an action. */
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

    /** Whether pictures of this generation are wanted. */
    synchronized boolean isCurrent(long which) {
        return which == generation && !closed;
    }

    /**
     * Waits until there is something to render.
     *
     * @param done the generation that needs no more rendering
     * @return null if the session was closed
     */
    synchronized Shot awaitShot(long done) throws InterruptedException {
        while (!closed && (scene == null || generation == done)) {
            wait();
        }
        return closed ? null : shot();
    }

    /** What is to be rendered now; there is a scene. */
    synchronized Shot shot() {
        requireScene();
        return new Shot(generation, Scenes.seenBy(scene, viewpoint.camera()), film, size());
    }

    /** What a final render is to show; there is a scene. */
    synchronized Seen seen() {
        requireScene();
        Scene.Display display = new Scene.Display(exposure, whole.display().tone());
        return new Seen(Scenes.seenAs(whole, viewpoint.camera(), display), film, moment);
    }

    /** A final render begins or has ended: it has the processors while nothing moves. */
    synchronized void background(boolean isUnderWay) {
        hasBackground = isUnderWay;
        notifyAll();
    }

    /** Whether what is to be seen has changed lately. */
    synchronized boolean isInUse() {
        return System.nanoTime() - restarted < IN_USE_NANOS;
    }

    /** Waits while a final render is under way and the picture that is wanted is there already, at full resolution. */
    synchronized void awaitProcessors(long which) throws InterruptedException {
        while (hasBackground
                && isCurrent(which)
                && frame != null
                && frame.generation() == which
                && frame.shrink() == 1) {
            wait();
        }
    }

    /** Shows a picture, unless it is out of date. */
    synchronized void publish(Frame next) {
        if (isCurrent(next.generation())) {
            frame = next;
            picture++;
            changed();
        }
    }

    /** The scene cannot be rendered as it is now. */
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

    /** A page looks at a layer: renders make what it needs. */
    synchronized void wish(Layer layer) {
        looks.wish(layer);
        notifyAll();
    }

    /** Ends all wishes, since they cannot be had: pages that still look ask again. */
    synchronized void clearWishes() {
        looks.clearWishes();
    }

    /**
     * Waits until a page looks at something that is not there.
     *
     * @return null if the session was closed
     */
    synchronized LayerRefinement.Wish awaitWish() throws InterruptedException {
        while (!closed && (scene == null || looks.missing(generation).isEmpty())) {
            wait();
        }
        return closed ? null : new LayerRefinement.Wish(shot(), looks.missing(generation));
    }

    /** Shows layers, unless they are out of date. */
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
     * @throws InvalidValueException if there is none yet
     */
    synchronized void keep() {
        if (frame == null) {
            throw new InvalidValueException("picture", "is not there yet");
        }
        looks.keep(frame, snapshot().shown());
        note = "";
        changed();
    }

    /** Forgets the picture that was kept. */
    synchronized void forget() {
        looks.forget();
        note = "";
        changed();
    }

    /** At which exposure pictures are shown, in stops. */
    synchronized double exposure() {
        return exposure;
    }

    /**
     * Waits until there is something newer than a version.
     *
     * @param millis no longer than this
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

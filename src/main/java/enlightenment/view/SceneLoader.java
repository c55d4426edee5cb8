package enlightenment.view;

import enlightenment.file.InputFile;
import enlightenment.file.WholeFile;
import enlightenment.math.InvalidValueException;
import enlightenment.render.Film;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import enlightenment.scene.json.SceneWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;

/** Reads the scene file of a view after changes to it or to files it names, and saves the camera. */
final class SceneLoader {
    /** The parts of a scene file that a view can change. */
    private static final List<String> PARTS = List.of("/camera", "/display");

    /** The most objects of a scene whose further files are watched: finding them takes a text of all objects. */
    private static final int MOST_OBJECTS = 20_000;

    private static final int CHECKS_BEFORE_RETRY = 4;

    private final SceneSource source;
    private final ViewSession session;

    /** Files of the scene, the scene file first; {@link #stamps} has their stamps from before they were read. */
    private List<Path> files;

    private List<FileStamp> stamps;

    /** Whether the last read succeeded, so that the session shows the scene of the file. */
    private boolean isLoaded;

    private int checksSinceFailure;

    /** The animation frame that the user has chosen; empty if none. */
    private OptionalInt chosen = OptionalInt.empty();

    SceneLoader(SceneSource source, ViewSession session) {
        this.source = source;
        this.session = session;
        files = List.of(source.file());
    }

    /** Thrown for a save that is refused; the message is the reason. */
    static final class Refusal extends Exception {
        private static final long serialVersionUID = 1;

        Refusal(String message) {
            super(message);
        }
    }

    /**
     * Reads the scene and shows it.
     *
     * @throws SceneException if the scene cannot be read or used
     */
    synchronized void load() {
        stamps = FileStamp.of(files);
        isLoaded = false;
        Scene scene = source.read();
        OptionalInt frame = frameOf(scene);
        Scene shown = frame.equals(source.frame()) ? scene : source.read(frame.getAsInt());
        isLoaded = true;
        List<FileStamp> all = new ArrayList<>(stamps.subList(0, 1));
        files = filesOf(scene);
        all.addAll(FileStamp.of(files.subList(1, files.size())));
        stamps = all;
        // Last: once the scene is seen, its files may change at once.
        session.loaded(shown, filmOf(scene), frame);
    }

    /** The chosen frame, if the scene still has it; else the frame of the source. */
    private OptionalInt frameOf(Scene scene) {
        boolean hasFrame = chosen.isPresent()
                && scene.animation().isPresent()
                && chosen.getAsInt() < scene.animation().get().frames();
        return hasFrame ? chosen : source.frame();
    }

    private Film filmOf(Scene scene) {
        return scene.animation().isPresent()
                ? Film.of(scene.animation().get(), source::read)
                : Film.of(1, 1, frame -> scene);
    }

    /**
     * Shows a frame of the scene's animation.
     *
     * @param frame counted from 0
     * @throws InvalidValueException if the animation has no such frame
     * @throws SceneException if the frame's scene cannot be used
     */
    synchronized void show(int frame) {
        ViewSession.Seen seen = session.seen();
        int frames = seen.scene().animation().map(Animation::frames).orElse(0);
        if (frame < 0 || frame >= frames) {
            throw new InvalidValueException(
                    "frame", frames == 0 ? "is not there: nothing is animated" : "must be in 0.." + (frames - 1));
        }
        Scene scene = seen.film().scene(frame);
        chosen = OptionalInt.of(frame);
        session.loaded(scene, seen.film(), chosen);
    }

    /**
     * Reads the scene if one of its files has changed since the last read. After a failure it is also read at every
     * {@value #CHECKS_BEFORE_RETRY}th check, since a missing file may have appeared.
     */
    synchronized void check() {
        boolean isRetry = !isLoaded && ++checksSinceFailure >= CHECKS_BEFORE_RETRY;
        if (!isRetry && FileStamp.of(files).equals(stamps)) {
            return;
        }
        checksSinceFailure = 0;
        try {
            load();
        } catch (SceneException e) {
            session.broken(ViewSession.lines(e));
        } catch (RuntimeException e) {
            session.broken(List.of("internal error: " + e));
        } catch (OutOfMemoryError e) {
            session.broken(List.of(source.file() + ": out of memory; java -Xmx sets how much there is"));
        }
    }

    /** The scene file, then the files that the scene names, such as textures and meshes. */
    private List<Path> filesOf(Scene scene) {
        Set<Path> all = new LinkedHashSet<>(List.of(source.file()));
        if (scene.objects().size() > MOST_OBJECTS) {
            return List.copyOf(all);
        }
        SceneWriter.FileNames names = file -> {
            all.add(file);
            return file.toString();
        };
        try {
            SceneWriter.toJson(scene.withInstants(List.of()), names);
        } catch (SceneException e) {
            // A mesh of another program's file has no file of its own: the file itself is watched.
            return List.copyOf(all);
        }
        return List.copyOf(all);
    }

    /** The reason in words why a view cannot be saved; "" if it can. */
    String reasonAgainstSaving(Snapshot view) {
        if (!source.isNative()) {
            return "this is a file of another program: 'enlightenment convert' makes a scene file of it";
        }
        if (view.scene() != null && PARTS.stream().anyMatch(part -> isAnimated(view.scene(), part))) {
            return "camera or exposure are animated: the tracks of the file say what they are";
        }
        return "";
    }

    private static boolean isAnimated(Scene scene, String part) {
        return scene.animation().isPresent()
                && scene.animation().get().tracks().stream()
                        .anyMatch(t -> t.target().startsWith(part + "/"));
    }

    /**
     * Writes camera and exposure of the view into the scene file; its other text stays.
     *
     * @throws Refusal if the view cannot be saved, or the file has changed since it was read; the file is then unchanged
     */
    synchronized void save() throws Refusal {
        Snapshot view = session.snapshot();
        String reason = reasonAgainstSaving(view);
        if (!reason.isEmpty()) {
            throw new Refusal(reason);
        }
        Path file = source.file();
        if (!isLoaded || !FileStamp.of(file).equals(stamps.get(0))) {
            throw new Refusal("the file has changed since it was read: nothing was written");
        }
        try {
            String text = new String(InputFile.bytes(file), StandardCharsets.UTF_8);
            String edited = edited(text, view);
            requireReadable(edited, view);
            WholeFile.write(file, edited);
        } catch (IOException e) {
            throw new Refusal(e.getMessage());
        } catch (IllegalArgumentException | SceneException e) {
            throw new Refusal("the camera cannot be written: " + e.getMessage());
        }
        check();
    }

    private static String edited(String text, Snapshot view) {
        Scene scene = view.scene();
        String edited =
                SceneWriter.withCamera(text, scene.camera(), view.viewpoint().camera());
        return view.exposure() == scene.display().exposure()
                ? edited
                : SceneWriter.withExposure(edited, view.exposure());
    }

    /** Fails unless the edited text is a scene with exactly the camera of the view. */
    private void requireReadable(String edited, Snapshot view) {
        Path folder = source.file().toAbsolutePath().getParent();
        byte[] bytes = edited.getBytes(StandardCharsets.UTF_8);
        Scene scene = SceneReader.readBytes(bytes, folder, source.file().toString(), OptionalInt.empty());
        if (!scene.camera().equals(view.viewpoint().camera())) {
            throw new IllegalArgumentException("it would not be read as what is seen");
        }
    }
}

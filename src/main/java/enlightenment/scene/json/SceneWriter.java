package enlightenment.scene.json;

import enlightenment.camera.Camera;
import enlightenment.file.WholeFile;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.tree.JsonPointer;
import enlightenment.scene.json.tree.JsonPrinter;
import enlightenment.scene.json.tree.JsonTree;
import enlightenment.scene.json.tree.JsonValue;
import enlightenment.scene.json.tree.Problems;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.file.Path;

/**
 * Writes scene files that {@link SceneReader} reads back as an equal scene.
 *
 * <p>Equal means all that a {@link Scene} holds: numbers are written as the shortest decimals that are exactly what they
 * were. It does not hold what a file may have beside that: comments, and which of several equal materials an object
 * named. A texture that is used but has no name gets one, which then is in the scene that is read.
 *
 * <p>A scene with {@link Scene#instants} is refused, which a frame of an animation with an open shutter is: the format can say how things
 * move over frames, but not what stands where at each moment of one.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class SceneWriter {
    private SceneWriter() {}

    /**
     * Writes a scene to a file, whole or not at all, replacing what is there; paths of textures become relative to the file's folder.
     *
     * @throws SceneException if the scene holds something that the format cannot say, such as a coordinate of 1e-500 or motion blur
     * @throws UncheckedIOException if the file cannot be written
     */
    public static void write(Scene scene, Path file) {
        String json = toJson(scene, file.toAbsolutePath().getParent());
        try {
            WholeFile.write(file, json);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * The text of a scene.
     *
     * @param baseFolder what paths of textures are made relative to
     * @throws SceneException if the scene holds something that the format cannot say
     */
    public static String toJson(Scene scene, Path baseFolder) {
        return toJson(scene, relativeTo(baseFolder));
    }

    /** Calls files by their paths relative to a folder. */
    public static FileNames relativeTo(Path baseFolder) {
        return SceneToJson.relativeTo(baseFolder)::of;
    }

    /**
     * The text of a scene whose files are called by other names than their paths; see {@link
     * SceneReader#readNamed}.
     *
     * @param fileNames gives the names of files
     * @throws SceneException if the scene holds something that the format cannot say
     */
    public static String toJson(Scene scene, FileNames fileNames) {
        if (!scene.instants().isEmpty()) {
            throw SceneException.of(
                    "",
                    "the format cannot say what a frame with motion blur shows: its "
                            + scene.instants().size() + " moments");
        }
        String json = JsonPrinter.print(new SceneToJson(scene, fileNames).json());
        if (scene.animation().isPresent()) {
            checkAnimation(json);
        }
        return json;
    }

    /**
     * The text of a camera as a scene file has it: one JSON object, without a line end behind it.
     *
     * @throws SceneException if the format cannot say a number of it, such as a coordinate of 1e-500
     */
    public static String toJson(Camera camera) {
        return SceneEdit.json(camera);
    }

    /**
     * The text of a scene file with another camera: what differs between two cameras is replaced, value by value. All other characters stay as they
     * are: comments, order, layout, spelling of numbers.
     *
     * @param text a scene file that {@link SceneReader} reads; a byte order mark may stand first
     * @param before the camera of that file
     * @param after the camera to be written, of the kind of {@code before}
     * @return the new text; {@code text} itself if the cameras are equal
     * @throws IllegalArgumentException if the cameras are of different kinds, or the text is no JSON object with a camera
     */
    public static String withCamera(String text, Camera before, Camera after) {
        return SceneEdit.withCamera(text, before, after);
    }

    /**
     * The text of a scene file with another exposure, in the part {@code display}, which is added if there is none. All other characters stay as they
     * are.
     *
     * @param text a scene file that {@link SceneReader} reads
     * @param exposure in stops, −1000..1000
     * @return the new text
     * @throws IllegalArgumentException if the text is no JSON object
     */
    public static String withExposure(String text, double exposure) {
        return SceneEdit.withExposure(text, exposure);
    }

    /** Tracks of scenes made in code may lead anywhere: those that lead to no number of the text are refused. */
    private static void checkAnimation(String json) {
        Problems problems = new Problems("", "");
        JsonValue root = JsonTree.parse(() -> new StringReader(json), problems);
        problems.throwIfAny();
        new Tracks(root, new Values(problems, null))
                .read(((JsonValue.Obj) root).get("animation"), JsonPointer.ROOT.child("animation"));
        problems.throwIfAny();
    }

    /** How the text of a scene calls the files that belong to it. Called by the thread that writes the scene. */
    public interface FileNames extends FileNaming {}
}

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
 * Writer of scene files that {@link SceneReader} reads back as an equal scene.
 *
 * <p>All components of a {@link Scene} are equal: numbers are written as the shortest decimals with exactly their value. Comments of a file, and
 * which of several equal materials an object named, are not part of a scene. A texture without a name gets one, which the scene that is read has,
 * too.
 *
 * <p>A scene with {@link Scene#instants}, such as a frame of an animation with an open shutter, is refused: the format describes motion over frames,
 * but not the scene at each instant of one.
 *
 * <p>All methods are thread-safe.
 */
public final class SceneWriter {
    private SceneWriter() {}

    /**
     * Writes a scene to a file atomically, replacing an existing one; paths of textures become relative to the file's folder.
     *
     * @throws SceneException if the format cannot represent the scene, such as a coordinate of 1e-500 or motion blur
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
     * @param baseFolder the folder that paths of textures are made relative to
     * @throws SceneException if the format cannot represent the scene
     */
    public static String toJson(Scene scene, Path baseFolder) {
        return toJson(scene, relativeTo(baseFolder));
    }

    /** Names files by their paths relative to a folder. */
    public static FileNames relativeTo(Path baseFolder) {
        return SceneToJson.relativeTo(baseFolder)::of;
    }

    /**
     * The text of a scene with given names of files in place of their paths; see {@link SceneReader#readNamed}.
     *
     * @param fileNames the names of files
     * @throws SceneException if the format cannot represent the scene
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
     * The JSON object of a camera in a scene file, without a line end behind it.
     *
     * @throws SceneException if the format cannot represent one of its numbers, such as a coordinate of 1e-500
     */
    public static String toJson(Camera camera) {
        return SceneEdit.json(camera);
    }

    /**
     * The text of a scene file with another camera. The values that differ between two cameras are replaced; comments, order, layout and spelling of
     * all other numbers are unchanged.
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
     * The text of a scene file with another exposure. The part {@code display} is added if there is none; all other text is unchanged.
     *
     * @param text a scene file that {@link SceneReader} reads
     * @param exposure the exposure in stops, −1000..1000
     * @return the new text
     * @throws IllegalArgumentException if the text is no JSON object
     */
    public static String withExposure(String text, double exposure) {
        return SceneEdit.withExposure(text, exposure);
    }

    /** Refuses tracks whose targets are not numbers of the text, as tracks made in code are unchecked. */
    private static void checkAnimation(String json) {
        Problems problems = new Problems("", "");
        JsonValue root = JsonTree.parse(() -> new StringReader(json), problems);
        problems.throwIfAny();
        new Tracks(root, new Values(problems, null))
                .read(((JsonValue.Obj) root).get("animation"), JsonPointer.ROOT.child("animation"));
        problems.throwIfAny();
    }

    /** Names of a scene's files in its text. Called by the thread that writes the scene. */
    public interface FileNames extends FileNaming {}
}

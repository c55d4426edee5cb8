package enlightenment.scene.json;

import enlightenment.scene.Scene;
import java.nio.file.Path;
import java.util.Objects;
import java.util.OptionalInt;

/**
 * A scene file that is read for each frame of a film: its meshes, with their hierarchies, are read when they are first met, and shared by the scenes
 * from then on. So a mesh file that changes meanwhile is not noticed. Safe for several threads, of which one reads at a time.
 */
public final class SceneFile {
    private final Path file;
    private final MeshCache meshes = new MeshCache();

    /** @param file the scene file; it is not looked at yet */
    public SceneFile(Path file) {
        this.file = Objects.requireNonNull(file, "file");
    }

    /**
     * Reads the scene as its file's own numbers say.
     *
     * @throws enlightenment.scene.SceneException as {@link SceneReader#read(Path)}
     */
    public synchronized Scene read() {
        return SceneReader.read(file, OptionalInt.empty(), meshes);
    }

    /**
     * Reads a frame, counted from 0.
     *
     * @throws enlightenment.scene.SceneException as {@link SceneReader#read(Path, int)}
     */
    public synchronized Scene read(int frame) {
        return SceneReader.read(file, OptionalInt.of(frame), meshes);
    }
}

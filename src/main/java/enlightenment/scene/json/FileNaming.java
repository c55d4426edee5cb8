package enlightenment.scene.json;

import enlightenment.mesh.TriangleMesh;
import java.nio.file.Path;
import java.util.Optional;

/** How the text of a scene calls its files; programs see it as part of {@code SceneWriter}. */
interface FileNaming {
    /** The name of a file of an image or of intensities, or of one that a mesh was read from. */
    String of(Path file);

    /** The name of a file that holds a mesh just as it is; empty to name the file that it was read from, and what was made of it. */
    default Optional<String> of(TriangleMesh mesh) {
        return Optional.empty();
    }
}

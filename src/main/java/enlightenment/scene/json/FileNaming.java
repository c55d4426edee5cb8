package enlightenment.scene.json;

import enlightenment.mesh.TriangleMesh;
import java.nio.file.Path;
import java.util.Optional;

/** Names of files in the text of a scene; its public form is part of {@code SceneWriter}. */
interface FileNaming {
    /** The name of an image, of a file of intensities, or of the file that a mesh was read from. */
    String of(Path file);

    /** The name of a file that holds exactly this mesh; empty to write the original file and its processing. */
    default Optional<String> of(TriangleMesh mesh) {
        return Optional.empty();
    }
}

package enlightenment.importer.pbrt;

import enlightenment.importer.support.ImportFailure;
import enlightenment.scene.SceneException;
import java.nio.file.Path;

/**
 * A line of a file.
 *
 * @param file the file
 * @param line from 1
 * @param isMain whether it is the imported file, and none that it includes
 */
record Place(Path file, int line, boolean isMain) {
    /** For a note. */
    String shown() {
        return (isMain ? "" : file.getFileName() + " ") + "line " + line;
    }

    /** The exception that refuses what stands here. */
    SceneException failure(String message) {
        return ImportFailure.at(file, line, message);
    }
}

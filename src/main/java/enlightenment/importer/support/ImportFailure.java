package enlightenment.importer.support;

import enlightenment.scene.SceneException;
import enlightenment.text.Plain;
import java.nio.file.Path;
import java.util.List;

/** Makes the exceptions by which readers refuse files. */
public final class ImportFailure {
    private ImportFailure() {}

    /**
     * A file that cannot be used.
     *
     * @param line the line, from 1; 0 if there is none
     * @param message what is wrong and what was expected; names from the file are made harmless here
     */
    public static SceneException at(Path file, int line, String message) {
        return new SceneException(
                List.of(new SceneException.Problem(file.toString(), line, 0, "", Plain.lines(message))));
    }
}

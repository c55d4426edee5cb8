package enlightenment.cli.input;

import enlightenment.cli.terminal.CliException;
import enlightenment.file.FileFailure;
import enlightenment.importer.SceneImporter;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;

/** Files of other programs. */
public final class ForeignScene {
    private ForeignScene() {}

    /**
     * Reads a file.
     *
     * @throws SceneException if it cannot be used
     * @throws CliException if it cannot be read, which is the user's mistake, as a missing file is
     */
    public static SceneImporter.Result read(Path file, SceneImporter.Options options) {
        try {
            return SceneImporter.read(file, options);
        } catch (IOException e) {
            throw CliException.wrongUsage(FileFailure.described(e));
        }
    }
}

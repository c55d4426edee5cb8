package enlightenment.importer;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * What a reader of foreign files may be told.
 *
 * @param extracted the folder that pictures are written to which the file holds inside, such as those of a GLB; made when it is needed. Scenes name
 *     them there, so they must stay as long as the scene is used. Empty for a temporary one that goes when the process ends
 * @param up which axis points upwards in a model without a camera; empty for z in STL files and y in others
 * @param camera the number of the camera in the file's order, from 0, where it has several
 */
public record ImportOptions(Optional<Path> extracted, Optional<Up> up, int camera) {
    /** The usual choices. */
    public static final ImportOptions DEFAULT = new ImportOptions(Optional.empty(), Optional.empty(), 0);

    /** An axis that points upwards. */
    public enum Up {
        Y,
        Z
    }

    /** Checks that nothing is missing. */
    public ImportOptions {
        Objects.requireNonNull(extracted, "extracted");
        Objects.requireNonNull(up, "up");
    }
}

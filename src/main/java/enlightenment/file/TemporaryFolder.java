package enlightenment.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A folder among the system's temporary ones that goes when the process ends in an orderly way, with the files that were announced. */
public final class TemporaryFolder {
    private final Path folder;

    /** Makes a folder that only its owner may look into, as far as the file system knows permissions. */
    public TemporaryFolder() throws IOException {
        folder = Files.createTempDirectory("enlightenment-");
        folder.toFile().deleteOnExit();
    }

    /** The folder itself. */
    public Path folder() {
        return folder;
    }

    /** The place of a file in it, which is removed when the process ends: the caller writes it. */
    public Path file(String name) {
        Path file = folder.resolve(name);
        file.toFile().deleteOnExit();
        return file;
    }
}

package enlightenment.render;

import java.nio.file.Path;
import java.util.Objects;

/**
 * Where a picture is kept while it is rendered, if it is too large for the memory. Its file there has no name or a new one, and is gone with
 * the picture, or with the process.
 *
 * @param folder best that of the finished picture
 * @param memory the most bytes that the pixels may take in memory, at least 0
 */
public record ScratchFolder(Path folder, long memory) {
    /** Nothing may be null. */
    public ScratchFolder {
        Objects.requireNonNull(folder, "folder");
        if (memory < 0) {
            throw new IllegalArgumentException("memory must be at least 0, not " + memory);
        }
    }

    /** For pictures that take more than half of the memory there is. */
    public static ScratchFolder of(Path folder) {
        return new ScratchFolder(folder, Runtime.getRuntime().maxMemory() / 2);
    }
}

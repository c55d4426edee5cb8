package enlightenment.file;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/**
 * Writes a file such that it appears as a whole or not at all: next to its place under another name, then moved. What was
 * there before stays until the new file is complete, and another name of it (a hard link) keeps what it held.
 */
public final class WholeFile {
    private static final int BUFFER = 1 << 16;

    /** What writes the file's bytes. */
    @FunctionalInterface
    public interface Content {
        /** Writes all of it; the stream is buffered and stays open. */
        void writeTo(OutputStream out) throws IOException;
    }

    private WholeFile() {}

    /**
     * Writes or replaces a file. A symbolic link is followed, also where it leads to no file yet; into a device or a pipe
     * the content goes directly.
     *
     * @throws IOException with a message that names the file and the reason; nothing is left behind
     */
    public static void write(Path file, Content content) throws IOException {
        try {
            if (Files.isDirectory(file)) {
                throw new IOException("it is a folder");
            }
            if (!Files.exists(file)) {
                Path folder = file.toAbsolutePath().getParent();
                if (folder == null || !Files.isDirectory(folder)) {
                    throw new IOException("there is no folder " + folder);
                }
                replace(FilePlace.of(file), content);
            } else if (!Files.isWritable(file)) {
                throw new IOException("it is read-only");
            } else if (Files.isRegularFile(file)) {
                replace(file.toRealPath(), content);
            } else {
                try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file), BUFFER)) {
                    content.writeTo(out);
                }
            }
        } catch (IOException e) {
            String reason = e instanceof NoSuchFileException ? "no file can be created there" : FileFailure.reason(e);
            throw new IOException("cannot write " + file + ": " + reason, e);
        }
    }

    /** Writes or replaces a file that holds a text in UTF-8. */
    public static void write(Path file, String text) throws IOException {
        write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static void replace(Path place, Content content) throws IOException {
        TemporaryFile.cleanOnce(place.getParent());
        try (TemporaryFile temporary = TemporaryFile.in(place.getParent())) {
            OutputStream out = new BufferedOutputStream(temporary.stream(), BUFFER);
            content.writeTo(out);
            out.flush();
            temporary.force();
            temporary.replace(place);
        }
    }
}

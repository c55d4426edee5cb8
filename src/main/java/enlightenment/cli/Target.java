package enlightenment.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Locale;

/** Files that will be written: checked before the work, so that an hour's render does not end in a wrong folder. */
final class Target {
    private Target() {}

    /** Fails unless the file can be written there, as far as can be told without trying. */
    static void check(Path file) {
        if (Standard.is(file)) {
            throw CliException.wrongUsage(
                    "only the picture (-o) can go to standard output, \"-\"; \"./-\" is a file of that name");
        }
        if (Files.isDirectory(file)) {
            throw CliException.failed(file + ": cannot be written: it is a folder");
        }
        if (Files.exists(file) && !Files.isWritable(file)) {
            throw CliException.failed(file + ": cannot be written: it is write-protected");
        }
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.exists(folder)) {
            throw CliException.failed(file + ": cannot be written: there is no folder " + folder);
        }
        if (!Files.isDirectory(folder)) {
            throw CliException.failed(file + ": cannot be written: " + folder + " is not a folder");
        }
        if (!Files.isWritable(folder)) {
            throw CliException.failed(file + ": cannot be written: no permission to write to the folder " + folder);
        }
    }

    /** Whether both are names of one file. */
    static boolean same(Path a, Path b) throws IOException {
        if (Standard.is(a) || Standard.is(b)) {
            return false;
        }
        if (a.toAbsolutePath().normalize().equals(b.toAbsolutePath().normalize())) {
            return true;
        }
        return Files.exists(a) && Files.exists(b) && Files.isSameFile(a, b);
    }

    /** The file's extension in small letters with its dot, or "" if it has none. */
    static String extension(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
    }

    /** Writes a text in UTF-8, whole or not at all. */
    static void write(Path file, String text) throws IOException {
        Path absolute = file.toAbsolutePath();
        Path part = absolute.resolveSibling(
                "." + absolute.getFileName() + "." + ProcessHandle.current().pid() + ".part");
        try {
            // Not a temporary file, whose permissions would be narrower than those of other new files.
            try (OutputStream out =
                    Files.newOutputStream(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
                out.write(text.getBytes(StandardCharsets.UTF_8));
            }
            try {
                Files.move(part, absolute, StandardCopyOption.ATOMIC_MOVE);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(part, absolute, StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (IOException e) {
            throw new IOException(file + ": cannot be written: " + Failures.describe(e), e);
        } finally {
            Files.deleteIfExists(part);
        }
    }
}

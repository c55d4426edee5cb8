package enlightenment.cli;

import enlightenment.file.WholeFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Files that will be written: checked before the work, so that an hour's render does not end in a wrong folder. */
final class OutputFile {
    private OutputFile() {}

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

    /** The file's extension in small letters with its dot, or "" if it has none. */
    static String extension(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
    }

    /** Writes a text in UTF-8, whole or not at all. */
    static void write(Path file, String text) throws IOException {
        WholeFile.write(file, text);
    }
}

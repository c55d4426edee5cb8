package enlightenment.cli.option;

import java.nio.file.Path;
import java.util.Locale;

/** Parts of the names of files. */
public final class FileNames {
    private FileNames() {}

    /** The extension in small letters with its dot, or "" if there is none. */
    public static String extension(Path file) {
        String name = last(file);
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot).toLowerCase(Locale.ROOT);
    }

    /** The name without folder and extension. */
    public static String stem(Path file) {
        String name = last(file);
        return name.substring(0, name.length() - extension(file).length());
    }

    private static String last(Path file) {
        Path last = file.getFileName();
        return last == null ? "" : last.toString();
    }
}

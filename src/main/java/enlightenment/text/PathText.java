package enlightenment.text;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Names of files that Java cannot say: it encodes and decodes them as the locale has it, and with the letters of ASCII only where
 * there is none, as in cron, batch systems and containers.
 */
public final class PathText {
    /** What a name has where its bytes mean nothing in the locale. */
    private static final char UNKNOWN = '\ufffd';

    private PathText() {}

    /** Why a text is no path, in words that stand behind the name of what it is the value of. */
    public static String reason(InvalidPathException e) {
        return reason(e, encoding());
    }

    static String reason(InvalidPathException e, Charset names) {
        String quoted = Plain.quoted(e.getInput());
        return isAboutLocale(e, names) ? "the name " + quoted + inexpressible(names) : "is not a path: " + quoted;
    }

    /** Whether it is the locale that has no letters for the text. */
    public static boolean isAboutLocale(InvalidPathException e) {
        return isAboutLocale(e, encoding());
    }

    private static boolean isAboutLocale(InvalidPathException e, Charset names) {
        return e.getInput().indexOf('\0') < 0 && isBeyond(e.getInput(), names);
    }

    /** Why nothing can be found by names that are relative to the working folder; empty if it can. */
    public static Optional<String> problemOfWorkingFolder() {
        return problemOfWorkingFolder(System.getProperty("user.dir"), encoding());
    }

    static Optional<String> problemOfWorkingFolder(String folder, Charset names) {
        boolean isDoubtful = folder.indexOf(UNKNOWN) >= 0 || isBeyond(folder, names);
        return isDoubtful && !exists(folder)
                ? Optional.of("the working folder " + Plain.quoted(folder) + inexpressible(names))
                : Optional.empty();
    }

    private static boolean exists(String folder) {
        try {
            return Files.isDirectory(Path.of(folder));
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private static boolean isBeyond(String text, Charset names) {
        return !names.equals(StandardCharsets.UTF_8) && !names.newEncoder().canEncode(text);
    }

    private static String inexpressible(Charset names) {
        String help = names.equals(StandardCharsets.UTF_8) ? "" : "; LC_ALL=C.UTF-8 helps";
        return " cannot be expressed in this locale (" + names.name() + ")" + help;
    }

    /** How names of files are encoded: not by Java's default, which newer versions choose whatever the locale is. */
    private static Charset encoding() {
        String name = System.getProperty("sun.jnu.encoding");
        return name == null ? Charset.defaultCharset() : Charset.forName(name);
    }
}

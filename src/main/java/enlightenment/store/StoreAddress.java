package enlightenment.store;

import enlightenment.text.PathText;
import enlightenment.text.Plain;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The address of a store: the path of a SQLite file, or the JDBC URL of any database.
 *
 * @param url the JDBC URL; without a password, but the part after its path may still be confidential
 * @param file the file of a store that is one
 */
public record StoreAddress(String url, Optional<Path> file) {
    static final String JDBC = "jdbc:";
    private static final String SQLITE = "jdbc:sqlite:";
    private static final int LONGEST_SHOWN = 200;

    /** {@code password=...} among the properties, under whatever name, or {@code user:password@} before the host. */
    private static final Pattern PASSWORD =
            Pattern.compile("[?&;,(]\\s*\\w*(pass|pwd)\\w*\\s*=|//[^/?@]*:[^/?@]*@", Pattern.CASE_INSENSITIVE);

    /** What comes before the host. */
    private static final Pattern USER = Pattern.compile("//[^/?;@]*@");

    /**
     * The address that a text is.
     *
     * @throws IllegalArgumentException if it is none, or has a password in it
     */
    public static StoreAddress of(String text) {
        if (!text.regionMatches(true, 0, JDBC, 0, JDBC.length())) {
            try {
                Path path = Path.of(text);
                // What follows a question mark would be taken for options.
                if (text.isBlank() || text.contains("?") || text.startsWith(":") || text.startsWith("file:")) {
                    throw new IllegalArgumentException(Plain.quoted(text) + " is no name for the file of a store");
                }
                return new StoreAddress(SQLITE + path, Optional.of(path));
            } catch (InvalidPathException e) {
                throw noPath(e);
            }
        }
        if (PASSWORD.matcher(text).find()) {
            throw new IllegalArgumentException("a password must not be in the URL, which others can see:"
                    + " put it into ENLIGHTENMENT_STORE_PASSWORD or a file for --store-password-file");
        }
        String url = JDBC + text.substring(JDBC.length());
        if (scheme(url).isEmpty()) {
            throw new IllegalArgumentException(
                    Plain.quoted(text) + " does not say which database it is, as jdbc:mariadb://host/name does");
        }
        // The driver takes capital letters too.
        if (!url.regionMatches(true, 0, SQLITE, 0, SQLITE.length())) {
            return new StoreAddress(url, Optional.empty());
        }
        String path = url.substring(SQLITE.length()).replaceFirst("\\?.*", "");
        if (path.isBlank() || path.startsWith(":")) {
            throw new IllegalArgumentException("a store in memory is lost with the process: name a file");
        }
        if (path.startsWith("file:")) {
            // It may be anything, in memory too, and only SQLite can resolve which file it is.
            throw new IllegalArgumentException(Plain.quoted(text) + " is the URL of a URL: give the path of the file");
        }
        try {
            return new StoreAddress(url, Optional.of(Path.of(path)));
        } catch (InvalidPathException e) {
            throw noPath(e);
        }
    }

    private static IllegalArgumentException noPath(InvalidPathException e) {
        String why = PathText.isAboutLocale(e)
                ? PathText.reason(e)
                : Plain.quoted(e.getInput()) + " is no path: " + e.getReason();
        return new IllegalArgumentException(why, e);
    }

    /**
     * The files that SQLite keeps beside a store's while it is open, and after a process was killed. SQLite follows links first.
     *
     * @param file the file of a store, which is no link
     */
    public static List<Path> beside(Path file) {
        return List.of(sibling(file, "-wal"), sibling(file, "-shm"), sibling(file, "-journal"));
    }

    private static Path sibling(Path file, String suffix) {
        return file.resolveSibling(file.getFileName() + suffix);
    }

    /** Which kind of database it is, in small letters: what stands between the first two colons. */
    String scheme() {
        return scheme(url);
    }

    private static String scheme(String url) {
        int end = url.indexOf(':', JDBC.length());
        return end < 0 ? "" : url.substring(JDBC.length(), end).toLowerCase(Locale.ROOT);
    }

    /** The address in messages: without options and without a user's name. */
    public String shown() {
        String plain = file.isPresent()
                ? file.get().toString()
                : USER.matcher(url.replaceFirst("[?;].*", "")).replaceFirst("//");
        return Plain.line(plain, LONGEST_SHOWN);
    }

    @Override
    public String toString() {
        return shown();
    }
}

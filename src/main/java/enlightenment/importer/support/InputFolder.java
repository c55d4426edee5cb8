package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.regex.Pattern;

/** The folder that an imported file lies in: files that it names must lie in it, or below it. */
public final class InputFolder {
    private static final Pattern URL = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:.*", Pattern.DOTALL);

    private final Path folder;

    /** @param file the imported file */
    public InputFolder(Path file) {
        Path parent = file.toAbsolutePath().normalize().getParent();
        folder = parent == null ? file.toAbsolutePath() : parent;
    }

    /**
     * The file of a name that stands in the imported file; both slashes separate folders.
     *
     * @throws IOException whose message is fit to be shown, if the name leads out of the folder (also by a link), is a URL or no path, or no such
     *     file can be read
     */
    public Path file(String name) throws IOException {
        String shown = Plain.quoted(name);
        if (URL.matcher(name).matches()) {
            throw new IOException(shown + " is a URL: only files beside the scene are read");
        }
        Path path;
        try {
            path = folder.resolve(name.replace('\\', '/')).normalize();
        } catch (InvalidPathException e) {
            throw new IOException(shown + " is no name of a file", e);
        }
        if (!path.startsWith(folder)) {
            throw new IOException(shown + " leads out of the folder of the scene");
        }
        if (!Files.isRegularFile(path) || !Files.isReadable(path)) {
            throw new IOException("there is no file " + shown + " that can be read");
        }
        if (!path.toRealPath().startsWith(folder.toRealPath())) {
            throw new IOException(shown + " is a link that leads out of the folder of the scene");
        }
        return path;
    }
}

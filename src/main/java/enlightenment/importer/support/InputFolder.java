package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * An imported file and the folder that it lies in: files that it names must lie there or below, or in or below another folder that the user
 * allows. Immutable.
 */
public final class InputFolder {
    private static final Pattern URL = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:.*", Pattern.DOTALL);

    private final Path imported;
    private final Path folder;

    /** The other folder; null for none. */
    private final Path assets;

    /** @param file the imported file, whose folder is the only one */
    public InputFolder(Path file) {
        this(file, Optional.empty());
    }

    /**
     * Makes the folder of a file.
     *
     * @param file the imported file
     * @param assets another folder of files that it may name
     */
    public InputFolder(Path file, Optional<Path> assets) {
        imported = file;
        Path parent = file.toAbsolutePath().normalize().getParent();
        folder = parent == null ? file.toAbsolutePath() : parent;
        this.assets = assets.map(other -> other.toAbsolutePath().normalize()).orElse(null);
    }

    /** The imported file. */
    public Path imported() {
        return imported;
    }

    /**
     * The file of a name that stands in the imported file; both slashes separate folders.
     *
     * @throws IOException whose message is fit to be shown, if the name leads out of the folders (also by a link), is a URL or no path, or no such
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
        if (!path.startsWith(folder) && (assets == null || !path.startsWith(assets))) {
            throw new IOException(shown + " leads out of " + allowed());
        }
        if (!Files.isRegularFile(path) || !Files.isReadable(path)) {
            throw new IOException("there is no file " + shown + " that can be read");
        }
        Path real = path.toRealPath();
        if (!real.startsWith(folder.toRealPath()) && (assets == null || !real.startsWith(assets.toRealPath()))) {
            throw new IOException(shown + " is a link that leads out of " + allowed());
        }
        return path;
    }

    private String allowed() {
        return "the folder of the scene" + (assets == null ? "" : " and that of its assets");
    }
}

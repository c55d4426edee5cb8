package enlightenment.importer.support;

import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
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

    /** That of the file first. */
    private final List<Path> allowed;

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
        allowed = assets.map(other -> List.of(folder, other.toAbsolutePath().normalize()))
                .orElse(List.of(folder));
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
        if (allowed.stream().noneMatch(path::startsWith)) {
            throw new IOException(shown + " leads out of " + shownAllowed());
        }
        if (!Files.isRegularFile(path) || !Files.isReadable(path)) {
            throw new IOException("there is no file " + shown + " that can be read");
        }
        if (!isReallyAllowed(path.toRealPath())) {
            throw new IOException(shown + " is a link that leads out of " + shownAllowed());
        }
        return path;
    }

    private boolean isReallyAllowed(Path real) throws IOException {
        for (Path each : allowed) {
            if (Files.exists(each) && real.startsWith(each.toRealPath())) {
                return true;
            }
        }
        return false;
    }

    private String shownAllowed() {
        return "the folder of the scene" + (allowed.size() == 1 ? "" : " and that of its assets");
    }
}

package enlightenment.cli.option;

import enlightenment.cli.terminal.StandardStreams;
import enlightenment.text.PathText;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import picocli.CommandLine.ITypeConverter;

/** Options and parameters that name files or folders. */
public final class FilePath implements ITypeConverter<Path> {
    @Override
    public Path convert(String text) {
        if (text.isEmpty()) {
            // For Java it is the working folder.
            throw new BadValue("must not be empty");
        }
        try {
            return reachable(Path.of(text));
        } catch (InvalidPathException e) {
            throw PathText.isAboutLocale(e) ? unusable(PathText.reason(e)) : new BadValue(PathText.reason(e));
        }
    }

    /** @throws BadValue if the path is relative, and the working folder cannot be expressed in this locale */
    public static Path reachable(Path path) {
        if (!path.isAbsolute() && !StandardStreams.isNamed(path)) {
            PathText.problemOfWorkingFolder().ifPresent(problem -> {
                throw unusable(problem);
            });
        }
        return path;
    }

    public static BadValue unusable(String problem) {
        return new BadValue("cannot be used: " + problem);
    }
}

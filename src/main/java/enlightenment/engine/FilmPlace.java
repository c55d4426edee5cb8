package enlightenment.engine;

import java.nio.file.Path;
import java.util.Optional;

/**
 * The place of a picture's finished pixels while it is rendered.
 *
 * @param folder the folder of a {@link enlightenment.film.FilmInFile}; empty for memory
 */
public record FilmPlace(Optional<Path> folder) {
    /** In memory. */
    public static final FilmPlace MEMORY = new FilmPlace(Optional.empty());

    /** In a file in this folder. */
    public static FilmPlace in(Path folder) {
        return new FilmPlace(Optional.of(folder));
    }
}

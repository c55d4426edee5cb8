package enlightenment.importer;

import enlightenment.scene.Scene;
import java.util.List;
import java.util.Objects;

/**
 * What a foreign file became.
 *
 * @param scene the scene, with physical shading
 * @param notes what the file says but the scene does not, or not quite: in plain words that begin with the places in the file, fit to be shown
 */
public record ImportedScene(Scene scene, List<String> notes) {
    /** Copies the notes. */
    public ImportedScene {
        Objects.requireNonNull(scene, "scene");
        notes = List.copyOf(notes);
    }
}

package enlightenment.cli.scene;

import enlightenment.cli.option.WordOption;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;

/** The scenes to begin with: a template of each kind, and where a model stands in it. */
enum StarterKind {
    /** Balls of different matter before a plain wall. */
    STUDIO(new ModelPlace(new Vec3(0, 0, 0.3), 1.1, 2, "red paint")),
    /** An interior with a window and a lamp. */
    ROOM(new ModelPlace(new Vec3(-0.2, 0.74, 1), 0.35, 0.6, "china")),
    /** One object on a turntable, with an animation of one turn. */
    PRODUCT(new ModelPlace(new Vec3(0, 0.1, 0), 0.75, 1.05, "glaze")),
    /** A park in the light of a clear sky. */
    OUTDOOR(new ModelPlace(new Vec3(0, 0.7, 0), 1.4, 2.8, "red lacquer"));

    private final ModelPlace place;

    StarterKind(ModelPlace place) {
        this.place = place;
    }

    /** Where a model stands in place of the main object. */
    ModelPlace place() {
        return place;
    }

    /** The text of the template: a scene file, with marks that {@link StarterScene} replaces. */
    String template() {
        try (InputStream in = StarterKind.class.getResourceAsStream(this + ".json")) {
            if (in == null) {
                throw new IllegalStateException("the template of " + this + " is missing from the program");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The word for it on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    static final class Words extends WordOption<StarterKind> {
        Words() {
            super(List.of(values()));
        }
    }
}

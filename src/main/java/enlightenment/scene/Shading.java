package enlightenment.scene;

import java.util.Collection;
import java.util.Locale;
import java.util.stream.Collectors;

/** How surfaces are shaded: what one camera sample is worth. Which methods can render it is a matter of {@link Method#shadings}. */
public sealed interface Shading permits ClassicShading, PhysicalShading {
    /** The kinds of shading. */
    enum Model {
        /** {@link ClassicShading}. */
        CLASSIC,

        /** {@link PhysicalShading}. */
        PHYSICAL;

        /** The name in scene files. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** The names of some, in order, with "and" between them. */
        static String words(Collection<Model> models) {
            return models.stream().sorted().map(Model::word).collect(Collectors.joining(" and "));
        }
    }

    /** Which kind it is. */
    Model model();
}

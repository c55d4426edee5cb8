package enlightenment.material;

import enlightenment.check.Check;
import java.util.Objects;

/** What a surface does with light. */
public sealed interface Material permits Material.Matte, Material.Mirror, Material.Glass {

    /** The surface's colour, or the filter that it multiplies onto what is seen by it. */
    Texture color();

    /** Whether shadows show on the surface (false is the paper's {@code noShadow}). */
    boolean receivesShadows();

    /** The name of this kind of material in the scene format. */
    String type();

    /**
     * A surface shaded by the cosine rule.
     *
     * @param color its colour
     * @param receivesShadows whether shadows show on it
     */
    record Matte(Texture color, boolean receivesShadows) implements Material {
        public Matte {
            Objects.requireNonNull(color, "color");
        }

        public static Matte of(Texture color) {
            return new Matte(color, true);
        }

        @Override
        public String type() {
            return "matte";
        }
    }

    /**
     * A perfect mirror.
     *
     * @param color what it multiplies onto the mirrored colour
     * @param receivesShadows kept for symmetry; a mirror shows no shadows of its own
     */
    record Mirror(Texture color, boolean receivesShadows) implements Material {
        public Mirror {
            Objects.requireNonNull(color, "color");
        }

        public static Mirror of(Texture color) {
            return new Mirror(color, true);
        }

        @Override
        public String type() {
            return "mirror";
        }
    }

    /**
     * Glass: light is refracted by Snell's law, or reflected totally.
     *
     * @param color multiplied onto what is seen through the surface, at every passage through it
     * @param indexOfRefraction relative to what surrounds everything (1), greater than 0
     * @param transparency 0 (a matte surface) to 1 (clear): the share of what is seen that comes through
     * @param priority where solids overlap, the one of greater priority fills the overlap; where priorities are equal,
     *     the smaller solid (Schmidt and Budge, "Simple nested dielectrics in ray traced images", 2002)
     * @param receivesShadows whether shadows show on the opaque share
     */
    record Glass(Texture color, double indexOfRefraction, double transparency, int priority, boolean receivesShadows)
            implements Material {
        public Glass {
            Objects.requireNonNull(color, "color");
            Check.positive("indexOfRefraction", indexOfRefraction);
            Check.range("transparency", transparency, 0, 1);
        }

        public static Glass of(Texture color, double indexOfRefraction) {
            return new Glass(color, indexOfRefraction, 1, 0, true);
        }

        @Override
        public String type() {
            return "glass";
        }
    }
}

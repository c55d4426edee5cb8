package enlightenment.material;

import enlightenment.check.Check;
import java.util.Objects;

/**
 * What a surface does with light: an immutable description.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one.
 */
public sealed interface Material permits Material.Matte, Material.Mirror, Material.Glass {

    /** The surface's colour; for a mirror or glass, the filter that is multiplied onto what is seen in or through it. */
    Texture color();

    /** Whether shadows show on the surface (false is the paper's {@code noShadow}). */
    boolean receivesShadows();

    /** The name of this kind of material in the scene format, such as {@code "matte"}. */
    String type();

    /**
     * A diffuse surface, shaded by the cosine rule.
     *
     * @param color its colour
     * @param receivesShadows whether shadows show on it
     */
    record Matte(Texture color, boolean receivesShadows) implements Material {
        /** Validates the components, as {@link Material} states. */
        public Matte {
            Objects.requireNonNull(color, "color");
        }

        /** A matte surface that receives shadows. */
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
     * @param color what is multiplied onto the reflected colour
     * @param receivesShadows has no effect: a mirror shows no shadows of its own
     */
    record Mirror(Texture color, boolean receivesShadows) implements Material {
        /** Validates the components, as {@link Material} states. */
        public Mirror {
            Objects.requireNonNull(color, "color");
        }

        /** A mirror of this filter colour. */
        public static Mirror of(Texture color) {
            return new Mirror(color, true);
        }

        @Override
        public String type() {
            return "mirror";
        }
    }

    /**
     * Glass: light is refracted by Snell's law, or totally reflected.
     *
     * @param color multiplied onto what is seen through the surface, each time a ray crosses it
     * @param indexOfRefraction relative to the surrounding medium (1), greater than 0
     * @param transparency the share of what is seen that comes through: 0 (a matte surface) to 1 (clear)
     * @param priority where solids overlap, the one of higher priority fills the overlap; at equal priorities, the smaller one
     *     (Schmidt and Budge, "Simple nested dielectrics in ray traced images", 2002)
     * @param receivesShadows whether shadows show on the opaque share
     */
    record Glass(Texture color, double indexOfRefraction, double transparency, int priority, boolean receivesShadows)
            implements Material {
        /** Validates the components, as {@link Material} states. */
        public Glass {
            Objects.requireNonNull(color, "color");
            Check.positive("indexOfRefraction", indexOfRefraction);
            Check.range("transparency", transparency, 0, 1);
        }

        /** Clear glass of this filter colour and index of refraction, priority 0. */
        public static Glass of(Texture color, double indexOfRefraction) {
            return new Glass(color, indexOfRefraction, 1, 0, true);
        }

        @Override
        public String type() {
            return "glass";
        }
    }
}

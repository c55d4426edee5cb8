package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.color.Rgb;
import enlightenment.material.Medium;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Shading by the rendering equation: all light comes from lights, glowing surfaces and the background, on any number of paths.
 *
 * @param maxBounces the most scattering events of a path, 0..1,000,000: with 0 only what glows is seen, with 1 light that was
 *     scattered once; media count. Empty: nothing but chance ends a path, so that no light is left out
 * @param background the light that comes from everywhere that nothing hides
 * @param medium what fills the whole scene outside of its solids, such as fog; its index of refraction is 1. Empty: nothing does
 */
public record PhysicalShading(OptionalInt maxBounces, Background background, Optional<Medium> medium)
        implements Shading {
    /** The greatest limit on the scattering events of a path. */
    public static final int MAX_BOUNCES = ClassicShading.MAX_BOUNCES;

    /** No limit, and a black background. */
    public static final PhysicalShading DEFAULT = new PhysicalShading(OptionalInt.empty(), Rgb.BLACK);

    /**
     * Checks the range.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code maxBounces}) if the limit is out of it
     */
    public PhysicalShading {
        Objects.requireNonNull(background, "background");
        Objects.requireNonNull(medium, "medium");
        if (maxBounces.isPresent()) {
            int most = maxBounces.getAsInt();
            Check.that(
                    most >= 0 && most <= MAX_BOUNCES,
                    "maxBounces",
                    "must be a whole number in 0.." + MAX_BOUNCES + ", not " + most);
        }
    }

    /**
     * Shading in empty space with the same light from everywhere.
     *
     * @param background its radiance, linear; in the unit of lights
     * @throws enlightenment.math.InvalidValueException as the other constructor
     */
    public PhysicalShading(OptionalInt maxBounces, Rgb background) {
        this(maxBounces, new Background.Constant(background), Optional.empty());
    }

    @Override
    public Model model() {
        return Model.PHYSICAL;
    }
}

package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import java.util.Objects;

/** Checks that a surface reflects no more light than it receives. */
final class Reflectance {
    private Reflectance() {}

    /** Only colours that are stated as light can be too much; those of a screen end at 1. */
    static void check(Texture color) {
        Objects.requireNonNull(color, "color");
        if (color instanceof Texture.Solid solid) {
            check(solid.color());
        } else if (color instanceof Texture.Checker checker) {
            checker.colors().forEach(Reflectance::check);
        }
    }

    /** {@link #check(Texture)} for one colour. */
    static void check(Color color) {
        if (color instanceof Rgb light) {
            Check.that(
                    light.max() <= 1,
                    "color",
                    "reflects more than it receives: no component of a surface's colour may be above 1, as "
                            + light.max() + " is");
        }
    }
}

package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import enlightenment.math.InvalidValueException;
import java.util.Objects;

/** Checks the emission of each kind of light. */
final class Emissions {
    private Emissions() {}

    /** Checks the emission of a light with a surface: radiance or power. */
    static void checkSurface(String type, Color color, Emission emission) {
        check(color, emission);
        // Messages are only built where they are needed: a scene may have thousands of lights.
        if (emission.quantity() == Emission.Quantity.INTENSITY) {
            throw new InvalidValueException(
                    "intensity", "belongs to point lights; a " + type + " light has \"radiance\" or \"power\"");
        }
        checkNear(type, "radiance", emission);
    }

    /** Checks the emission of a light without extent: intensity or power. */
    static void checkPoint(String type, Color color, Emission emission) {
        check(color, emission);
        if (emission.quantity() == Emission.Quantity.RADIANCE) {
            throw new InvalidValueException(
                    "radiance",
                    "belongs to lights with a surface; a " + type + " light has \"intensity\" or \"power\"");
        }
        checkNear(type, "intensity", emission);
    }

    /** Checks the emission of a light at infinity: irradiance; the radiance of its disk is {@code perIrradiance} times that. */
    static void checkDistant(Color color, Emission emission, double perIrradiance) {
        check(color, emission);
        Check.that(
                emission.quantity() == Emission.Quantity.IRRADIANCE,
                emission.quantity().key(),
                "belongs to other lights; a distant light has \"irradiance\"");
        Check.that(emission.ultraviolet() == 0, "ultraviolet", "must be 0: a distant light gives visible light only");
        Rgb emitted = color.linear().times(emission.value());
        Check.that(
                emitted.max() * perIrradiance <= Radiance.LARGEST,
                "irradiance",
                "is too much for a disk of this \"angle\": its radiance must be at most 1e100");
    }

    private static void checkNear(String type, String usual, Emission emission) {
        if (emission.quantity() == Emission.Quantity.IRRADIANCE) {
            throw new InvalidValueException(
                    "irradiance", "belongs to distant lights; a " + type + " light has \"" + usual + "\" or \"power\"");
        }
    }

    private static void check(Color color, Emission emission) {
        Objects.requireNonNull(color, "color");
        Rgb light = color.linear();
        Rgb value = emission.value();
        double most = Math.max(light.r() * value.r(), Math.max(light.g() * value.g(), light.b() * value.b()));
        String key = emission.quantity().key();
        Check.that(most < Double.POSITIVE_INFINITY, key, "times the light's colour is beyond the range of doubles");
        // The brightness of power and intensity depends on the scene's size.
        boolean isRadiance = emission.quantity() == Emission.Quantity.RADIANCE;
        Check.that(!isRadiance || most <= Radiance.LARGEST, key, "times the light's colour must be at most 1e100");
    }
}

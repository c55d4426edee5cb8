package enlightenment.light;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.Radiance;
import enlightenment.color.Rgb;
import java.util.Objects;

/** Which quantities which lights have. */
final class Emissions {
    private Emissions() {}

    /** Of a light with a surface. */
    static void checkSurface(String type, Color color, Emission emission) {
        check(color, emission);
        Check.that(
                emission.quantity() != Emission.Quantity.INTENSITY,
                "intensity",
                "belongs to point lights; a " + type + " light has \"radiance\" or \"power\"");
    }

    /** Of a light without extent. */
    static void checkPoint(String type, Color color, Emission emission) {
        check(color, emission);
        Check.that(
                emission.quantity() != Emission.Quantity.RADIANCE,
                "radiance",
                "belongs to lights with a surface; a " + type + " light has \"intensity\" or \"power\"");
    }

    private static void check(Color color, Emission emission) {
        Objects.requireNonNull(color, "color");
        Rgb light = color.linear();
        Rgb value = emission.value();
        double most = Math.max(light.r() * value.r(), Math.max(light.g() * value.g(), light.b() * value.b()));
        String key = emission.quantity().key();
        Check.that(most < Double.POSITIVE_INFINITY, key, "times the light's colour is beyond the range of doubles");
        // How bright power and intensity are is a matter of the scene's size.
        boolean isRadiance = emission.quantity() == Emission.Quantity.RADIANCE;
        Check.that(!isRadiance || most <= Radiance.LARGEST, key, "times the light's colour must be at most 1e100");
    }
}

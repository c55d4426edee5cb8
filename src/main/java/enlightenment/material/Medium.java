package enlightenment.material;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.color.Rgb;
import java.util.Objects;

/**
 * What fills space or a solid and scatters and absorbs light on its way, the same everywhere: an immutable description. Only physical
 * shading knows it. Each band has a scattering coefficient and an absorption coefficient, whose sum is what is lost per scene unit of a
 * straight way, for small losses; where light is scattered, it goes on by the phase function of Henyey and Greenstein ("Diffuse
 * radiation in the galaxy", 1941).
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one.
 */
public sealed interface Medium permits Medium.Colored, Medium.Coefficients {

    /**
     * The mean cosine of the angle by which light is turned, between -1 and 1, exclusive: 0 scatters to all sides alike, more
     * mostly forwards, less mostly backwards.
     */
    double anisotropy();

    /**
     * A medium by its look.
     *
     * @param color the share of evenly incident light that a thick body of it, without an interface that reflects, gives back
     *     (its spherical albedo): at most 1
     * @param meanFreePath how far light comes on the average before something happens to it, in scene units, for each band:
     *     greater than 0
     * @param anisotropy see {@link Medium#anisotropy}
     */
    record Colored(Color color, Rgb meanFreePath, double anisotropy) implements Medium {
        /** Validates the components, as {@link Medium} states. */
        public Colored {
            Reflectance.check(Objects.requireNonNull(color, "color"));
            checkPath(meanFreePath.r());
            checkPath(meanFreePath.g());
            checkPath(meanFreePath.b());
            checkAnisotropy(anisotropy);
        }

        private static void checkPath(double length) {
            Check.positive("meanFreePath", length);
            Check.that(1 / length < Double.POSITIVE_INFINITY, "meanFreePath", "is too short for doubles: " + length);
        }

        /** A medium that scatters to all sides alike. */
        public static Colored of(Color color, Rgb meanFreePath) {
            return new Colored(color, meanFreePath, 0);
        }
    }

    /**
     * A medium by its physics.
     *
     * @param scattering the share that is scattered per scene unit, for small shares, in each band
     * @param absorption the share that is absorbed per scene unit, for small shares, in each band
     * @param anisotropy see {@link Medium#anisotropy}
     */
    record Coefficients(Rgb scattering, Rgb absorption, double anisotropy) implements Medium {
        /** Validates the components, as {@link Medium} states. */
        public Coefficients {
            checkSum(scattering.r() + absorption.r());
            checkSum(scattering.g() + absorption.g());
            checkSum(scattering.b() + absorption.b());
            checkAnisotropy(anisotropy);
        }

        private static void checkSum(double extinction) {
            Check.that(
                    extinction < Double.POSITIVE_INFINITY,
                    "scatteringCoefficient",
                    "plus the absorption coefficient is beyond the range of doubles");
        }

        /** A medium that scatters to all sides alike. */
        public static Coefficients of(Rgb scattering, Rgb absorption) {
            return new Coefficients(scattering, absorption, 0);
        }
    }

    private static void checkAnisotropy(double g) {
        Check.that(g > -1 && g < 1, "anisotropy", "must lie between -1 and 1, both excluded, not " + g);
    }
}

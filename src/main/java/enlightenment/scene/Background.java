package enlightenment.scene;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import enlightenment.material.Texture;
import java.util.Objects;

/**
 * The light that comes from everywhere that nothing hides, in physical shading: an immutable description. Up is +y; azimuths go
 * from +z, which is 0, over +x, which is 90°.
 *
 * <p>The constructors throw {@link enlightenment.math.InvalidValueException}, with the key of the scene format, for a value out
 * of range, and {@link NullPointerException} for a missing one.
 */
public sealed interface Background permits Background.Constant, Background.Picture, Background.Sky {

    /**
     * The same radiance from everywhere.
     *
     * @param radiance linear, in the unit of lights
     */
    record Constant(Rgb radiance) implements Background {
        /** No light. */
        public static final Constant BLACK = new Constant(Rgb.BLACK);

        /** Validates the components, as {@link Background} states. */
        public Constant {
            Radiance.check("radiance", radiance.max());
        }
    }

    /**
     * A picture of all directions, by longitude and latitude: its upper edge is straight up, its lower edge straight down, and
     * its middle column faces azimuth 0; azimuths grow to the right.
     *
     * @param picture the image file; its numbers become light as those of a surface's colour do
     * @param radiance the radiance of light 1 of the picture, for each band
     * @param rotation by how much the picture is turned about +y towards growing azimuths, in degrees
     */
    record Picture(Texture.File picture, Rgb radiance, double rotation) implements Background {
        /** Validates the components, as {@link Background} states. */
        public Picture {
            Objects.requireNonNull(picture, "picture");
            Radiance.check("radiance", radiance.max());
            Check.finite("rotation", rotation);
        }

        /** A picture as it is. */
        public static Picture of(Texture.File picture) {
            return new Picture(picture, Rgb.WHITE, 0);
        }
    }

    /**
     * A clear sky and the sun in it.
     *
     * @param elevation of the sun above the horizon, 0..90 degrees
     * @param azimuth of the sun, in degrees
     * @param turbidity how hazy the air is: {@link #LEAST_TURBIDITY} to {@link #GREATEST_TURBIDITY}; 2 is
     *     a very clear day, 3 a clear one, 6 a hazy one
     * @param groundAlbedo the share of light that the plain under the sky gives back, which is what is seen below the horizon: each
     *     band at most 1
     * @param radiance what the radiance of sky and sun is multiplied by, for each band
     * @param hasSun whether the sun's disk shines; without it there is the light of the sky alone
     */
    record Sky(double elevation, double azimuth, double turbidity, Rgb groundAlbedo, Rgb radiance, boolean hasSun)
            implements Background {
        /** Very clear air; the model makes no sense below. */
        public static final double LEAST_TURBIDITY = 2;

        /** Fog, almost. */
        public static final double GREATEST_TURBIDITY = 10;

        /** The turbidity of a sky that says none. */
        public static final double USUAL_TURBIDITY = 3;

        /** What the ground reflects under a sky that says nothing of it. */
        public static final Rgb USUAL_GROUND = Rgb.gray(0.2);

        /** Validates the components, as {@link Background} states. */
        public Sky {
            Check.range("elevation", elevation, 0, 90);
            Check.finite("azimuth", azimuth);
            Check.range("turbidity", turbidity, LEAST_TURBIDITY, GREATEST_TURBIDITY);
            Check.that(
                    groundAlbedo.max() <= 1,
                    "groundAlbedo",
                    "must lie in 0..1: ground does not give back more than it receives");
            Radiance.check("radiance", radiance.max());
        }

        /** The sky of a clear day, with its sun. */
        public static Sky of(double elevation, double azimuth) {
            return new Sky(elevation, azimuth, USUAL_TURBIDITY, USUAL_GROUND, Rgb.WHITE, true);
        }
    }
}

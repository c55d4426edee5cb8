package enlightenment.camera;

import enlightenment.check.Check;
import enlightenment.math.InvalidValueException;

/**
 * A thin lens in the place of the eye, perpendicular to the line of sight: depth of field (M. Potmesil and I. Chakravarty, "A lens and
 * aperture camera model for synthetic image generation", 1981). A pixel is the mean over the lens, so the radius does not change how bright
 * the picture is. Immutable.
 *
 * @param radius of the aperture in scene units, at least 0 and at most 1000 times {@code focusDistance}; 0 is a pinhole
 * @param focusDistance from the eye to the plane in focus, which is perpendicular to the line of sight, in scene units, greater than 0
 * @param blades the number of corners of the aperture, a regular polygon whose corners have the distance {@code radius} from its centre: 3
 *     to 100; 0 is a circle
 * @param rotation the angle in degrees from the picture's right to a corner of the aperture, counterclockwise in the picture
 */
public record Lens(double radius, double focusDistance, int blades, double rotation) {
    /** The largest radius of an aperture, in distances between the lens and the plane in focus: directions stay within range. */
    public static final int MOST_DISTANCES = 1000;

    private static final int LEAST_BLADES = 3;
    /** The largest number of corners of an aperture. */
    public static final int MOST_BLADES = 100;

    /**
     * Validates the components.
     *
     * @throws InvalidValueException with the key of the scene format
     */
    public Lens {
        Check.notNegative("radius", radius);
        Check.positive("focusDistance", focusDistance);
        Check.that(
                radius / MOST_DISTANCES <= focusDistance,
                "radius",
                "must be at most " + MOST_DISTANCES + " times \"focusDistance\", not " + radius);
        Check.that(
                blades == 0 || blades >= LEAST_BLADES && blades <= MOST_BLADES,
                "blades",
                "must be 0, for a circle, or a whole number from " + LEAST_BLADES + " to " + MOST_BLADES + ", not "
                        + blades);
        Check.finite("rotation", rotation);
    }

    /** A round lens. */
    public static Lens round(double radius, double focusDistance) {
        return new Lens(radius, focusDistance, 0, 0);
    }
}

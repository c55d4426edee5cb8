package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Scale;
import enlightenment.math.SceneFrame;

/** Lengths in a frame. */
public final class Sizes {
    /** What is smaller than this power of two in a frame, where the scene is about 1 large, has lost digits. */
    static final int LEAST_EXPONENT = -960;

    static final String TOO_SMALL = "this is less than a number can tell (the scene is more than 1e288 times as large)";

    private Sizes() {}

    /**
     * A length greater than 0 in a frame.
     *
     * @param key the key of the scene format that holds it
     * @throws Check.InvalidValueException if it is so small beside the scene that it is nothing as a double
     */
    public static double inFrame(String key, double length, SceneFrame frame) {
        double placed = frame.toFrame(length);
        Check.that(Scale.exponent(placed) >= LEAST_EXPONENT, key, "is too small: beside the whole scene, " + TOO_SMALL);
        return placed;
    }
}

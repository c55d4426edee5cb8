package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import enlightenment.math.Vec3;

/** Ends of solids that have an axis. */
final class Axes {
    private Axes() {}

    /**
     * From one end to the other in a frame: the difference is exact and rounded once. So a solid that is flat as a wafer
     * keeps its axis even where both ends are one point for doubles.
     *
     * @param key the key of the scene format that holds the far end
     * @throws Check.InvalidValueException if the axis is shorter than a double can be
     */
    static Vec3 between(String key, Point base, Point end, SceneFrame frame) {
        Vec3 axis = new SceneFrame(base, frame.exponent()).toFrame(end);
        Check.that(
                axis.exponent() >= Sizes.LEAST_EXPONENT,
                key,
                "is too close to \"base\": beside the whole scene, " + Sizes.TOO_SMALL);
        return axis;
    }
}

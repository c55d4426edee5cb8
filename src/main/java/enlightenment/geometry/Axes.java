package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.SceneFrame;
import enlightenment.math.Vec3;

/** Ends of solids that have an axis. */
final class Axes {
    private Axes() {}

    /**
     * The far end in a frame. Ends that differ as decimals can be one place in the frame, where only doubles are left:
     * then the solid has lost its axis, and nobody could see it anyway.
     *
     * @param key the key of the scene format that holds the far end
     * @throws Check.InvalidValueException if both ends are the same place in the frame
     */
    static Vec3 end(String key, Point base, Point end, SceneFrame frame) {
        Vec3 placed = frame.toFrame(end);
        Check.that(
                !placed.equals(frame.toFrame(base)),
                key,
                "is so close to \"base\" that from where the camera stands they are one point, as far as doubles tell");
        return placed;
    }
}

package enlightenment.primitive;

import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;

/** Ends of solids that have an axis. */
final class Axes {
    private Axes() {}

    /**
     * From one end to the other in a frame: the difference is exact and rounded once. So a solid that is flat as a wafer
     * keeps its axis even where both ends are one point for doubles, and even where no double is as small as it is thick.
     */
    static Vec3 between(ExactPoint base, ExactPoint end, SceneFrame frame) {
        Vec3 axis = new SceneFrame(base, frame.exponent()).toFrame(end);
        return axis.exponent() >= Sizes.LEAST_EXPONENT
                ? axis
                : base.directionTo(end).normalized().scaledBy(Sizes.LEAST_EXPONENT);
    }
}

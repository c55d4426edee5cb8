package enlightenment.primitive;

import enlightenment.frame.SceneFrame;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;

/** The axis of a cylinder or cone, from its exact end points. */
final class Axes {
    private Axes() {}

    /**
     * The vector from one end to the other in a frame: the difference is exact and rounded once. So a solid as flat as a wafer
     * keeps its axis even if both ends round to the same point of the frame, or if its thickness is below the smallest double.
     */
    static Vec3 between(ExactPoint base, ExactPoint end, SceneFrame frame) {
        Vec3 axis = new SceneFrame(base, frame.exponent()).toFrame(end);
        return axis.exponent() >= Sizes.MIN_EXPONENT
                ? axis
                : base.directionTo(end).normalized().scaledBy(Sizes.MIN_EXPONENT);
    }
}

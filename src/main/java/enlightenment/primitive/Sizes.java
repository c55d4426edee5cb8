package enlightenment.primitive;

import enlightenment.frame.SceneFrame;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** Lengths in a frame, where the extent of the scene is about 1. */
public final class Sizes {
    /** Lengths below this power of two, invisibly small beside the scene, are raised to it. */
    static final int MIN_EXPONENT = -960;

    private static final double MIN_LENGTH = Math.scalb(1.0, MIN_EXPONENT);

    private Sizes() {}

    /** A positive length in a frame, which stays positive however small it is beside the scene: a ball of radius 0 would not be a ball. */
    public static double inFrame(double length, SceneFrame frame) {
        return Math.max(frame.toFrame(length), MIN_LENGTH);
    }

    /** A length times a power of two; one that is not 0 does not become 0 however far a ray comes from. */
    static double scaled(double length, int k) {
        return length == 0 ? 0 : Math.max(Scale.scalb(length, k), MIN_LENGTH);
    }

    /** A vector other than 0 times a power of two: it keeps its direction however far a ray comes from. */
    static Vec3 scaled(Vec3 v, int k) {
        return v.scaledBy(Math.max(k, MIN_EXPONENT - v.exponent()));
    }
}

package enlightenment.primitive;

import enlightenment.frame.SceneFrame;

/** Lengths in a frame, where the extent of the scene is about 1. */
public final class Sizes {
    /** Lengths below this power of two, which nobody can see beside the scene, are raised to it. */
    static final int MIN_EXPONENT = -960;

    private static final double MIN_LENGTH = Math.scalb(1.0, MIN_EXPONENT);

    private Sizes() {}

    /**
     * A positive length in a frame. It stays positive there, however small it is beside the scene: a ball of radius 0 would not
     * be a ball.
     */
    public static double inFrame(double length, SceneFrame frame) {
        return Math.max(frame.toFrame(length), MIN_LENGTH);
    }
}

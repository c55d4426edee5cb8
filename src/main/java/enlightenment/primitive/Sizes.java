package enlightenment.primitive;

import enlightenment.frame.SceneFrame;

/** Lengths in a frame, where the scene is about 1 large. */
public final class Sizes {
    /** What is smaller than this power of two is lost beside the scene, and is taken for as large as this. */
    static final int LEAST_EXPONENT = -960;

    private static final double LEAST = Math.scalb(1.0, LEAST_EXPONENT);

    private Sizes() {}

    /**
     * A length greater than 0 in a frame: greater than 0 there too, however small it is beside the scene. Nobody sees the
     * difference, but a ball of no size would not be a ball.
     */
    public static double inFrame(double length, SceneFrame frame) {
        return Math.max(frame.toFrame(length), LEAST);
    }
}

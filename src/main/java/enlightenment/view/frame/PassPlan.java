package enlightenment.view.frame;

/**
 * A pass over a picture; passes go from coarse to full resolution, then add samples. A pure function of the measured times.
 *
 * @param shrink side in pixels of the block that one pixel of the pass stands for: a power of two, at most {@link #FIRST}
 * @param number number of the pass among those at full resolution, counted from 0; 0 for coarser ones
 * @param samples samples per pixel of the pass
 * @param before samples per pixel of earlier passes at full resolution
 */
public record PassPlan(int shrink, int number, int samples, int before) {
    /** The largest {@code shrink} once the speed of a scene is known: objects can still be recognized. */
    public static final int COARSEST = 16;

    /** The largest {@code shrink} of the first picture, whose speed is unknown and whose code is not yet compiled. */
    public static final int FIRST = 32;

    /** A pass with fewer pixels is not made coarser: it takes no noticeable time. */
    private static final int FEW_PIXELS = 1024;

    /** Longest expected time of a first pass, in seconds: shorter ones are perceived as immediate. */
    private static final double IMMEDIATE_SECONDS = 0.05;

    /** Approximate longest time of a pass, in seconds, so that the picture is seen to improve. */
    private static final double SECONDS_BETWEEN_PICTURES = 0.7;

    /**
     * The first pass after a change.
     *
     * @param secondsPerPixel measured time of one sample of a pixel; infinite if nothing was measured yet
     * @param pixels number of pixels at full resolution
     */
    public static PassPlan first(double secondsPerPixel, long pixels) {
        int coarsest = secondsPerPixel == Double.POSITIVE_INFINITY ? FIRST : COARSEST;
        int shrink = 1;
        while (shrink < coarsest && !isImmediate(secondsPerPixel, pixels / (shrink * shrink))) {
            shrink *= 2;
        }
        return new PassPlan(shrink, 0, 1, 0);
    }

    private static boolean isImmediate(double secondsPerPixel, long pixels) {
        return pixels < FEW_PIXELS || secondsPerPixel * pixels <= IMMEDIATE_SECONDS;
    }

    /**
     * The pass after this one.
     *
     * @param seconds measured time of this pass
     * @param most samples per pixel of a finished picture, at least 1
     * @return null if this was the last pass
     */
    public PassPlan next(double seconds, int most) {
        if (shrink > 1) {
            return new PassPlan(shrink / 2, 0, 1, 0);
        }
        int sum = before + samples;
        if (sum >= most) {
            return null;
        }
        // At most as many samples as all passes so far, so that each pass at most doubles their number.
        int wanted = seconds < SECONDS_BETWEEN_PICTURES / 2 ? Math.min(2 * samples, sum) : samples;
        int fewer = seconds > 2 * SECONDS_BETWEEN_PICTURES ? Math.max(samples / 2, 1) : wanted;
        return new PassPlan(1, number + 1, Math.min(fewer, most - sum), sum);
    }

    /** The number of pixels of this pass along a side of {@code full} pixels; at least 1. */
    public int side(int full) {
        return Math.max(full / shrink, 1);
    }
}

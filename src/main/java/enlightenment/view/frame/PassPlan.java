package enlightenment.view.frame;

/**
 * The passes over a picture, from coarse ones to fine ones and on to more samples. A pure function of the times that are given to it.
 *
 * @param shrink the side of the squares of pixels that one pixel of the pass stands for: a power of two, at most {@link #FIRST}
 * @param number of the pass among those at full resolution, counted from 0; 0 of coarser ones
 * @param samples per pixel of the pass
 * @param before samples per pixel of the passes at full resolution before this one
 */
public record PassPlan(int shrink, int number, int samples, int before) {
    /** The coarsest pass while a view is in use has one pixel for squares of this side: things can still be recognized. */
    public static final int COARSEST = 16;

    /** The side of these squares before anything is known of the scene, and most of the program waits to be compiled. */
    public static final int FIRST = 32;

    /** No pass has fewer pixels than about a quarter of this because it is coarse: they take no time. */
    private static final int FEW_PIXELS = 1024;

    /** A pass that is expected to take less is fine enough to begin with: the eye takes it for immediate. */
    private static final double IMMEDIATE_SECONDS = 0.05;

    /** A pass may take about as long, so that the picture is renewed often enough to be seen to improve. */
    private static final double SECONDS_BETWEEN_PICTURES = 0.7;

    /**
     * The first pass after a change.
     *
     * @param secondsPerPixel what one sample takes, from what was seen so far; infinite if nothing was
     * @param pixels of the picture at full resolution
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
     * @param seconds that this one took
     * @param most samples per pixel in all, at least 1
     * @return null if there are enough
     */
    public PassPlan next(double seconds, int most) {
        if (shrink > 1) {
            return new PassPlan(shrink / 2, 0, 1, 0);
        }
        int sum = before + samples;
        if (sum >= most) {
            return null;
        }
        // Never more than there are already: the picture does not become finer by less than half.
        int wanted = seconds < SECONDS_BETWEEN_PICTURES / 2 ? Math.min(2 * samples, sum) : samples;
        int fewer = seconds > 2 * SECONDS_BETWEEN_PICTURES ? Math.max(samples / 2, 1) : wanted;
        return new PassPlan(1, number + 1, Math.min(fewer, most - sum), sum);
    }

    /** The number of pixels along a side of this pass. */
    public int side(int full) {
        return Math.max(full / shrink, 1);
    }
}

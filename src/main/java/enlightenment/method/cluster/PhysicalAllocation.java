package enlightenment.method.cluster;

/**
 * The number of samples of a pixel of physical light. The variance of the mean of n samples is noise/n, as of independent ones, plus
 * edge/n^1.5 where an edge passes through the pixel, where well-distributed samples converge faster. The total error of a given number of
 * samples is least where noise/n² + 1.5 edge/n^2.5 = 1/effort, with the same effort everywhere; n is rounded to a power of two, since
 * points are distributed best at powers of two.
 */
final class PhysicalAllocation {
    private static final int MOST_SAMPLES = 24;

    /** The weight of an edge: γ of its n^−γ, times how much more than the corners' estimate it counts. */
    private static final double OF_EDGE = 1.5;

    /** Variance of an edge that may hide between corners that show none. */
    private static final double UNSEEN = 0x1p-27;

    /** The number rounds up to the next power of two at the square root of two, spread by a dither over pixels that need the same. */
    private static final double ROOT = 1.41421356237309504880;

    private static final double SMOOTHED = 0.125;

    /**
     * The share of the samples that all pixels get alike, by which the variance of paths is judged: indirect light has rare bright paths,
     * so that fewer samples tell too little.
     */
    private static final double EVERYWHERE = 0.5;

    private final double need;
    private final int least;

    /**
     * @param effort inverse of the reduction of variance that is worth one more sample
     * @param samples per pixel in the mean: a share of them is the same for all pixels
     */
    PhysicalAllocation(double effort, double samples) {
        need = 1 / effort;
        least = leastSamples(samples);
    }

    /** Binary logarithm of the least number of samples of every pixel. */
    static int leastSamples(double samples) {
        return Math.min(Math.max(Math.getExponent(EVERYWHERE * samples), 0), MOST_SAMPLES);
    }

    /**
     * Binary logarithm of the number of samples of a pixel.
     *
     * @param noise the variance of one of its samples, as shown
     * @param edge the variance, as shown, of an edge that passes through it
     * @param cost of a sample, in any unit
     * @param dither the pixel's threshold, 0..1
     */
    int samples(double noise, double edge, double cost, double dither) {
        double n = Math.scalb(ROOT + SMOOTHED * (dither - 0.5), least);
        double ofEdge = OF_EDGE * (edge + UNSEEN);
        int level = least;
        while (level < MOST_SAMPLES && noise + ofEdge / Math.sqrt(n) > need * cost * n * n) {
            n *= 2;
            level++;
        }
        return level;
    }
}

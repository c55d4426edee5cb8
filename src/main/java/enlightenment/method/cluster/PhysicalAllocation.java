package enlightenment.method.cluster;

/**
 * How many samples a pixel of physical light gets. The variance of the mean of n samples is noise/n, as of independent ones, plus
 * edge/n^1.5 where an edge passes through the pixel, of which well-distributed samples leave less. Spending a given number where they
 * reduce the whole picture's error most means noise/n² + 1.5 edge/n^2.5 = 1/effort, with the same effort everywhere; here as the nearest
 * power of two, since these are the numbers for which the points are best distributed.
 */
final class PhysicalAllocation {
    private static final int MOST_SAMPLES = 24;

    /** What an edge weighs: γ of its n^−γ, and how much more than the corners tell it is to be trusted. */
    private static final double OF_EDGE = 1.5;

    /** What may hide between the corners where nothing is seen to vary. */
    private static final double UNSEEN = 0x1p-27;

    /** The step to twice as many samples is at the square root of two, but for a part that is smoothed over pixels that need the same. */
    private static final double ROOT = 1.41421356237309504880;

    private static final double SMOOTHED = 0.125;

    /**
     * The share of the samples that goes everywhere, and shows how much paths vary: light of many bounces has rare bright paths, so
     * that less than this tells too little.
     */
    private static final double EVERYWHERE = 0.5;

    private final double need;
    private final int least;

    /**
     * @param effort inverse of the variance that is worth one more sample
     * @param samples how many are to be spent per pixel in the mean: a share of them goes everywhere
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
     * Binary logarithm of the number of samples for a pixel.
     *
     * @param noise the variance of one of its samples, as shown
     * @param edge the same of an edge that passes through it
     * @param cost what a sample costs, in any unit
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

package enlightenment.classic.cluster;

/**
 * How many samples a pixel gets. If the variance of a mean of n well-distributed samples is a n^−γ, spending a given number
 * of them where they reduce the whole picture's error most means n = (γ a · effort)^(1/(γ + 1)) with the same effort everywhere;
 * here as the nearest power of two, since these are the numbers for which the points are best distributed.
 */
final class Allocation {
    /** 1 + γ where the colour is smooth, and where edges or light points make it jump; measured in docs/notes/cluster-laboratory.md. */
    private static final double SMOOTH = 2.85;

    private static final double ROUGH = 2.5;

    /** How much cheaper than a camera ray a light point is, and how much more often it misjudges a pixel's need: chosen there. */
    private static final double LIGHT_POINTS_PER_RAY = 3;

    /** More light points per camera ray than this make no sense: the ray's own place matters then. */
    private static final int MOST_POINTS = 5;

    private static final int MOST_SAMPLES = 24;

    /**
     * Binary logarithm of the most samples of a pixel, beside that of their mean: what none of the blocks showed that the effort was
     * found with, a few pixels of those that none of 512 showed, then changes what is spent by some per cent, and not by any factor.
     */
    private static final int MOST_ABOVE_MEAN = 6;

    /**
     * The share of the samples that goes everywhere, whatever the corners saw: what they missed then costs no more than evenly
     * spaced rays with this share. A power of two below it, as all numbers of samples.
     */
    private static final double EVERYWHERE = 0.25;

    /**
     * How much of the step from a number of samples to twice as many is smoothed over the pixels that need the same: where all do,
     * any number in between can be spent. More than this would cost evenness.
     */
    private static final double SMOOTHED = 0.125;

    private final double effort;
    private final int least;
    private final int most;

    /**
     * @param effort inverse of the variance that is worth one more sample
     * @param samples how many are to be spent per pixel in the mean: a share of them goes everywhere
     * @param share of the pixels that are in blocks which may show more than background
     */
    Allocation(double effort, double samples, double share) {
        this.effort = effort;
        least = leastSamples(samples);
        // Background takes next to nothing of them.
        most = share > 0
                ? Math.min(Math.max(Math.getExponent(samples / share), 0) + MOST_ABOVE_MEAN, MOST_SAMPLES)
                : MOST_SAMPLES;
    }

    /** Binary logarithm of the least number of samples of every pixel. */
    static int leastSamples(double samples) {
        return Math.min(Math.max(Math.getExponent(EVERYWHERE * samples), 0), MOST_SAMPLES);
    }

    /**
     * Binary logarithm of the number of samples for a pixel of this demand ({@link SampleDemand}); one sample where nothing is
     * needed at all, which is known of empty blocks only.
     *
     * @param dither the pixel's threshold, 0..1
     */
    int samples(double film, double edge, double light, double dither) {
        if (film + edge + light == 0) {
            return 0;
        }
        double rounding = 0.5 + SMOOTHED * (dither - 0.5);
        int samples = Math.max(level(film, SMOOTH, rounding), level(edge, ROUGH, rounding));
        // With very many light points per ray, rays become the cheaper way to spread them.
        samples = Math.max(samples, lightPoints(light) - MOST_POINTS);
        return Math.min(Math.max(samples, least), most);
    }

    /** Binary logarithm of the number of light points that a pixel should take in all. */
    int lightPoints(double light) {
        return Math.min(level(LIGHT_POINTS_PER_RAY * light, ROUGH, 0.5), most + MOST_POINTS);
    }

    private int level(double variance, double onePlusGamma, double rounding) {
        double x = variance * effort;
        return x <= 1 ? 0 : (int) (log2(x) / onePlusGamma + rounding);
    }

    /** The binary logarithm, straight between powers of two: exact there, at most 0.09 too low between. */
    private static double log2(double x) {
        int exponent = Math.getExponent(x);
        return exponent + Math.scalb(x, -exponent) - 1;
    }
}

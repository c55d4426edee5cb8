package enlightenment.method.cluster;

/**
 * How many samples a pixel gets. If the variance of a mean of n well-distributed samples is a n^−γ, spending a given number
 * of them where the whole picture's error falls most means n = (γ a · effort)^(1/(γ + 1)) with the same effort everywhere;
 * here as the nearest power of two, since these are the numbers for which the points are best distributed.
 */
final class Allocation {
    /** 1 + γ where the colour is smooth, and where edges or light points make it jump; measured in docs/cluster-sampler.md. */
    private static final double SMOOTH = 2.85;

    private static final double ROUGH = 2.5;

    /** How much cheaper than a camera ray a light point is, and how much more often it misjudges a pixel's need: chosen there. */
    private static final double LIGHT_POINTS_PER_RAY = 3;

    /** More light points per camera ray than this make no sense: the ray's own place matters then. */
    private static final int MOST_POINTS = 5;

    private static final int MOST_SAMPLES = 24;

    private final double effort;

    /** @param effort inverse of the variance that is worth one more sample */
    Allocation(double effort) {
        this.effort = effort;
    }

    /** Binary logarithm of the number of samples for a pixel that needs so much ({@link Needs}). */
    int samples(double film, double edge, double light) {
        int samples = Math.max(level(film, SMOOTH), level(edge, ROUGH));
        // With very many light points per ray, rays become the cheaper way to spread them.
        return Math.min(Math.max(samples, lightPoints(light) - MOST_POINTS), MOST_SAMPLES);
    }

    /** Binary logarithm of the number of light points that a pixel should take in all. */
    int lightPoints(double light) {
        return Math.min(level(LIGHT_POINTS_PER_RAY * light, ROUGH), MOST_SAMPLES + MOST_POINTS);
    }

    private int level(double variance, double onePlusGamma) {
        double x = variance * effort;
        return x <= 1 ? 0 : (int) (log2(x) / onePlusGamma + 0.5);
    }

    /** The binary logarithm, straight between powers of two: exact there, at most 0.09 too low between. */
    private static double log2(double x) {
        int exponent = Math.getExponent(x);
        return exponent + Math.scalb(x, -exponent) - 1;
    }
}

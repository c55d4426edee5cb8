package enlightenment.film;

/**
 * How much variance is left in the means of pixels with 2^k samples, as a share of a first figure that their samples give (A),
 * told by the ratio of a second figure (B) to it; both are sums over all such pixels. The figures are the halves and quarters of
 * the samples ({@link SampleSpread}), and of one or two samples what the neighbours tell ({@link Neighbours}).
 *
 * <p>Two ends are known: of independent samples the share is 1, and B/A is 1 for one or two samples and 2 for more; straight
 * edges in random places and directions have V(1) : V(2) : V(4) : … = 1 : 0.294 : 0.0949 : 0.0321 : 0.0112. Between and beyond
 * them the curves were fitted to the true errors of shipped scenes. docs/cluster-sampler.md has the figures.
 */
final class Remainder {
    /** Of a single sample: 0.44 + 0.2 x + 0.36 x², which is 1 for noise and 0.5 at x = 0.12, for edges. */
    private static final double SINGLE_EDGE = 0.44;

    private static final double SINGLE_LINEAR = 0.2;
    private static final double LEAST_SINGLE_RATIO = -0.25;

    /** Of two samples, where the means of neighbours differ by more than noise: between 1/2.4, straight edges, and 1/3. */
    private static final double PAIR_EDGE = 0.38;

    private static final double PAIR_RATIO = 0.3;

    /** How fast the fall of the variance grows with the ratio where there is noise, and where there are edges. */
    private static final double STEEP = 1.25;

    private static final double FLAT = 0.25;

    /** The fall at edges from 2 to 4, from 4 to 8 and from 8 to 16 samples or further, and the ratio to which it belongs. */
    private static final double[] EDGE = {3.1, 3.05, 2.95};

    private static final double EDGE_RATIO = 2.8;

    /** From this ratio on the picture is smooth, and the fall may be anything. */
    private static final double SMOOTH_RATIO = 4.5;

    /** Slower than independent samples, or faster than this, the variance falls only by chance. */
    private static final double FASTEST = 8;

    /** What is left of the figure of one, two and four differences if nothing of it, and if all of it comes from light points. */
    private static final double[] OF_REST = {0.6, 0.6, 0.45};

    private static final double[] OF_LIGHT = {1, 0.4, 0.6};

    /** Least share that is left of single differences. */
    private static final double LEAST_OF_DIFFERENCES = 0.4;

    private Remainder() {}

    /**
     * The share of the first figure that is left.
     *
     * @param level binary logarithm of the number of samples
     * @param ratio of the second figure to the first
     * @param differences whether the samples are differences from a known part
     */
    static double share(int level, double ratio, boolean differences) {
        if (differences && level < OF_REST.length) {
            return level == 0 ? Math.min(Math.max(ratio, LEAST_OF_DIFFERENCES), 1) : 1;
        }
        if (level == 0) {
            double x = Math.min(Math.max(ratio, LEAST_SINGLE_RATIO), 1);
            return SINGLE_EDGE + x * (SINGLE_LINEAR + x * (1 - SINGLE_EDGE - SINGLE_LINEAR));
        }
        if (level == 1) {
            double x = Math.min(Math.max(ratio, PAIR_RATIO), 1);
            return PAIR_EDGE + (1 - PAIR_EDGE) * (x - PAIR_RATIO) / (1 - PAIR_RATIO);
        }
        return 1 / (fall(level, Math.min(Math.max(ratio, 2), FASTEST)) - 1);
    }

    /**
     * Differences from a known part leave isolated remainders, of which neither neighbours nor the ratio of quarters to halves
     * tell much: what is left of the first figure of a pixel with few of them, for each pixel by itself. Only of what comes from
     * light points do neighbours tell the variance of a single one.
     *
     * @param ofLight the share of the variance that comes from light points
     */
    static double ofDifferences(int count, double ofLight) {
        int level = count == 1 ? 0 : count == 2 ? 1 : 2;
        return count == 1 || count == 2 || count == 4
                ? OF_REST[level] + ofLight * (OF_LIGHT[level] - OF_REST[level])
                : 1;
    }

    /** From this level on the ratios of halves and quarters of all levels are comparable. */
    static int leastPooled(boolean differences) {
        return differences ? OF_REST.length : 2;
    }

    private static double fall(int level, double ratio) {
        double edge = EDGE[Math.min(level, EDGE.length + 1) - 2];
        double fall = Math.min(2 + STEEP * (ratio - 2), edge + FLAT * (ratio - EDGE_RATIO));
        return fall + (1 - FLAT) * Math.max(ratio - SMOOTH_RATIO, 0);
    }
}

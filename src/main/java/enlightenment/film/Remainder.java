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

    /** Of two samples, where the means of neighbours differ by more than noise: 1/(2.6 + 1). */
    private static final double PAIR_EDGE = 0.38;

    /** How fast the fall of the variance grows with the ratio where there is noise, and where there are edges. */
    private static final double STEEP = 1.5;

    private static final double FLAT = 0.25;

    /** The fall at edges from 2 to 4, from 4 to 8 and from 8 to 16 samples or further, and the ratio to which it belongs. */
    private static final double[] EDGE = {3.25, 3.15, 3.0};

    private static final double EDGE_RATIO = 2.8;

    /** From this ratio on the picture is smooth, and the fall may be anything. */
    private static final double SMOOTH_RATIO = 4.5;

    /** Slower than independent samples, or faster than this, the variance falls only by chance. */
    private static final double FASTEST = 8;

    /**
     * The same for one, two and four samples that are differences from a known part. That leaves isolated remainders, of which
     * neighbours tell nothing, and the ratio of quarters to halves does not either.
     */
    private static final double[] OF_DIFFERENCES = {0.72, 0.57, 0.5};

    private Remainder() {}

    /**
     * The share of the first figure that is left.
     *
     * @param level binary logarithm of the number of samples
     * @param ratio of the second figure to the first
     * @param differences whether the samples are differences from a known part
     */
    static double share(int level, double ratio, boolean differences) {
        if (differences && level < OF_DIFFERENCES.length) {
            return OF_DIFFERENCES[level];
        }
        if (level == 0) {
            double x = Math.min(Math.max(ratio, LEAST_SINGLE_RATIO), 1);
            return SINGLE_EDGE + x * (SINGLE_LINEAR + x * (1 - SINGLE_EDGE - SINGLE_LINEAR));
        }
        if (level == 1) {
            double x = Math.min(Math.max(ratio, 0), 1);
            return PAIR_EDGE + (1 - PAIR_EDGE) * x * x;
        }
        return 1 / (fall(level, Math.min(Math.max(ratio, 2), FASTEST)) - 1);
    }

    private static double fall(int level, double ratio) {
        double edge = EDGE[Math.min(level, EDGE.length + 1) - 2];
        double fall = Math.min(2 + STEEP * (ratio - 2), edge + FLAT * (ratio - EDGE_RATIO));
        return fall + (1 - FLAT) * Math.max(ratio - SMOOTH_RATIO, 0);
    }
}

package enlightenment.film;

/**
 * How much variance is left in the means of pixels with 2^k samples. It is a share of a first figure that their samples give (A), as a
 * function of the ratio of a second figure (B) to it; both are sums over all such pixels. The figures are the halves and quarters of the
 * samples ({@link SampleSpread}), and for one or two samples the differences of neighbours ({@link Neighbours}).
 *
 * <p>For one or two samples the figures give the variance itself. For more they only show how fast it has fallen so far. Three FITTED
 * curves extrapolate it: the middle, the least and the most that was found on shipped scenes and on hard ones (sub-pixel slats, wires,
 * textures of noise, checkerboards, lit spots, small lights). Two ends are known: for independent samples B/A is 2 and the share is 1, and
 * never is it much more; straight edges in random places and directions have V(1) : V(2) : V(4) : … = 1 : 0.294 : 0.0949 : 0.0321 : 0.0112.
 * docs/notes/cluster-laboratory.md has the figures.
 */
final class VarianceDecay {
    /** Ratios B/A for which the curves are given; straight between them. */
    private static final double[] RATIO = {2, 2.3, 2.6, 3, 3.5, 4.2, 5, 6, 8};

    /** The share of A at least, in the middle, and at most; fitted. */
    private static final double[] LEAST = {0.45, 0.43, 0.42, 0.41, 0.35, 0.3, 0.2, 0.17, 0.12};

    private static final double[] MIDDLE = {0.98, 0.71, 0.57, 0.51, 0.46, 0.37, 0.23, 0.19, 0.14};
    private static final double[] MOST = {1.08, 0.95, 0.76, 0.64, 0.57, 0.49, 0.36, 0.28, 0.2};

    /** {@link #LEAST} and {@link #MIDDLE} of four samples, which differ; {@link #MOST} does not. */
    private static final double[] LEAST_OF_FOUR = {0.33, 0.35, 0.37, 0.38, 0.34, 0.3, 0.2, 0.17, 0.12};

    private static final double[] MIDDLE_OF_FOUR = {0.98, 0.71, 0.57, 0.48, 0.45, 0.35, 0.22, 0.18, 0.14};

    /** For a single sample the figure is the variance; the true one was found this much less or more. */
    private static final double SINGLE_LEAST = 0.85;

    private static final double SINGLE_MOST = 1.15;

    /** Half of a shortfall below this counts as chance for two samples, whose ratio is a difference of greater numbers. */
    private static final double PAIR_USUAL = 0.4;

    private static final double PAIR_LEAST_SHARE = 0.3;
    private static final double PAIR_LEAST = 0.7;
    private static final double PAIR_MOST = 1.25;

    /** Means are never much worse than those of independent samples; fitted, as all that follows. */
    private static final double WORST = 1.08;

    /** What is left of the figure of one, two and four differences if nothing of it, and if all of it comes from light points. */
    private static final double[] OF_REST = {0.8, 0.6, 0.5};

    private static final double[] OF_LIGHT = {1, 0.85, 0.85};

    /** By how much the error of one, two and four differences was found to differ from that. */
    private static final double[] LEAST_OF_DIFFERENCES = {0.5, 0.65, 0.5};

    private static final double[] MOST_OF_DIFFERENCES = {1.3, 1.6, 1.8};

    /** Numbers that are no power of two are worse than those of the next lower one; between the curve and independence. */
    private static final int OTHERS_LEVEL = 3;

    private VarianceDecay() {}

    /** The kinds of samples. */
    enum Samples {
        /** Colours that a screen takes. */
        WHOLE,

        /** Differences of those from a known part. */
        DIFFERENCES,

        /** Linear light: {@link PathDecay}. */
        LIGHT
    }

    /** Which of the three curves: what is to be expected, or the smallest or the largest that was found. */
    enum Curve {
        LEAST,
        MIDDLE,
        MOST
    }

    /**
     * The share of the first figure that is left.
     *
     * @param level binary logarithm of the number of samples, or negative for numbers of which there is none
     * @param ratio of the second figure to the first
     * @param samples what they are
     */
    static double share(Curve curve, int level, double ratio, Samples samples) {
        return samples == Samples.LIGHT
                ? PathDecay.share(curve, level, ratio)
                : share(curve, level, ratio, samples == Samples.DIFFERENCES);
    }

    /** @param differences whether the samples are differences from a known part */
    private static double share(Curve curve, int level, double ratio, boolean differences) {
        if (level < 0) {
            double s = share(curve, OTHERS_LEVEL, ratio, false);
            return curve == Curve.LEAST ? s : curve == Curve.MOST ? WORST : (s + 1) / 2;
        }
        if (differences && level < OF_REST.length) {
            return of(curve, LEAST_OF_DIFFERENCES[level], MOST_OF_DIFFERENCES[level]);
        }
        if (level == 0) {
            return of(curve, SINGLE_LEAST, SINGLE_MOST);
        }
        if (level == 1) {
            double share = Math.min(ratio < PAIR_USUAL ? (ratio + PAIR_USUAL) / 2 : ratio, 1);
            share = Math.max(share, PAIR_LEAST_SHARE) * of(curve, PAIR_LEAST, PAIR_MOST);
            return Math.min(share, WORST);
        }
        double[] values = curve == Curve.MOST ? MOST : curve == Curve.LEAST ? LEAST : MIDDLE;
        if (level == 2 && curve != Curve.MOST) {
            values = curve == Curve.LEAST ? LEAST_OF_FOUR : MIDDLE_OF_FOUR;
        }
        return between(ratio, values);
    }

    private static double of(Curve curve, double least, double most) {
        return curve == Curve.LEAST ? least : curve == Curve.MOST ? most : 1;
    }

    private static double between(double ratio, double[] values) {
        int last = RATIO.length - 1;
        double x = Math.min(Math.max(ratio, RATIO[0]), RATIO[last]);
        int k = 0;
        while (k < last - 1 && x > RATIO[k + 1]) {
            k++;
        }
        double t = (x - RATIO[k]) / (RATIO[k + 1] - RATIO[k]);
        return values[k] + t * (values[k + 1] - values[k]);
    }

    /**
     * Differences from a known part leave remainders that do not look alike in neighbouring pixels, and of which the ratio of
     * quarters to halves tells little: what is left of the first figure of a pixel with few of them, for each pixel by itself.
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
    static int leastPooled(Samples samples) {
        return samples == Samples.DIFFERENCES ? OF_REST.length : 2;
    }
}

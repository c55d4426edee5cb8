package enlightenment.sampling;

/**
 * The linear distribution, a tent: the density falls linearly on both sides of the mean, (1 − |z|/√6) / √6 for |z| ≤ √6, and
 * is 0 beyond. Sampling it takes one square root.
 */
public final class LinearDistribution implements Distribution {
    static final LinearDistribution INSTANCE = new LinearDistribution();

    /** Half the width of the support: the variance of a tent is w²/6. */
    static final double HALF_WIDTH = Math.sqrt(6);

    private LinearDistribution() {}

    @Override
    public String name() {
        return "linear";
    }

    @Override
    public double density(double z) {
        double left = 1 - Math.abs(z) / HALF_WIDTH;
        return left > 0 ? left / HALF_WIDTH : 0;
    }

    @Override
    public double cumulative(double z) {
        double left = Math.max(HALF_WIDTH - Math.abs(z), 0) / HALF_WIDTH;
        double tail = 0.5 * left * left;
        return z < 0 ? tail : 1 - tail;
    }

    @Override
    public double quantile(double p) {
        double z = HALF_WIDTH * fromPeak(Truncated.smallerTail(p), Math.abs(p - 0.5));
        return p < 0.5 ? -z : z;
    }

    /** The distance from the peak in half widths, given the probability of the tail beyond and that from the mean. */
    static double fromPeak(double tail, double fromMiddle) {
        return 2 * fromMiddle / (1 + Math.sqrt(2 * tail));
    }
}

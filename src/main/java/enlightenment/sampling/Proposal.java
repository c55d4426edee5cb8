package enlightenment.sampling;

/**
 * A {@link Distribution} moved to a mean, stretched by a deviation, cut off outside an interval and scaled so that its
 * integral over the interval is 1. Mutable, not for use by several threads at once, allocation free.
 *
 * <p>Sampling is by inversion, so well distributed numbers give well distributed values. Sampling and density agree to about
 * 1e-12, wherever the mean lies, so that the weights f/density of an importance sampler are unbiased to that order. The mean
 * may lie far outside: a normal proposal then falls off from the end of the interval as its tail does. Where the family has
 * no density in the interval at all (only the linear one may), the proposal is uniform.
 *
 * <p>Deviations may be far below the rounding of the mean: {@link #offset} gives values relative to it, and
 * {@link #densityAtOffset} their density. Use this pair unless the deviation is well above the rounding of the values.
 */
public final class Proposal {
    /** What 1/2 of the last bit of a 53-bit number adds: 0 and 1 have no value if the interval is infinite. */
    private static final double LEAST = 0x1p-54;

    private static final double MOST = 1 - 0x1p-53;

    /** Distances beyond this many deviations change nothing: all of the density lies within rounding of the interval's end. */
    private static final double FARTHEST = 0x1p500;

    private final Distribution family;
    private final Truncated truncated;
    private double mean;
    private double low;
    private double high;
    private double lowOffset;
    private double highOffset;

    /** Where the positions of the truncated density are counted from, the same as an offset, and their unit, with a sign. */
    private double origin;

    private double originOffset;
    private double unit;
    private double perUnit;
    private double perDeviation;
    private boolean uniform;

    /** A proposal of this family, standardised and not cut off until {@link #set} is called. */
    public Proposal(Distribution family) {
        this.family = family;
        truncated = Truncated.of(family);
        set(0, 1, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** The family it was made of. */
    public Distribution family() {
        return family;
    }

    /**
     * Moves, stretches and cuts off.
     *
     * @param mean of the family before it is cut off; finite, need not lie in the interval
     * @param deviation of the family before it is cut off; finite and greater than 0; for densities that do not overflow or
     *     underflow, from 1e-300 to 1e300
     * @param low the lower end of the interval, perhaps infinite
     * @param high the upper end of the interval, greater than the lower one, perhaps infinite
     * @throws IllegalArgumentException if a value is not as described, or if the proposal would be uniform on an interval of
     *     infinite length
     */
    public void set(double mean, double deviation, double low, double high) {
        if (!(Math.abs(mean) < Double.POSITIVE_INFINITY
                && deviation > 0
                && deviation < Double.POSITIVE_INFINITY
                && low < high)) {
            throw new IllegalArgumentException(
                    "no proposal of mean " + mean + " and deviation " + deviation + " within " + low + ".." + high);
        }
        this.mean = mean;
        perDeviation = 1 / deviation;
        this.low = low;
        this.high = high;
        lowOffset = low - mean;
        highOffset = high - mean;
        uniform = false;
        if (low < mean && mean < high) {
            origin = mean;
            originOffset = 0;
            unit = deviation;
            truncated.around(-lowOffset / deviation, highOffset / deviation);
        } else {
            beyond(mean <= low, deviation);
        }
        perUnit = 1 / unit;
    }

    private void beyond(boolean above, double deviation) {
        origin = above ? low : high;
        originOffset = above ? lowOffset : highOffset;
        unit = above ? deviation : -deviation;
        double distance = Math.min(Math.abs(originOffset) / deviation, FARTHEST);
        uniform = !truncated.beyond(distance, (high - low) / deviation);
        if (uniform && high - low == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "no density within " + low + ".." + high + ", which is too long for a uniform one");
        }
    }

    /**
     * The value below which the share u of the density lies.
     *
     * @param u in [0, 1)
     * @return within the interval; grows with u
     */
    public double sample(double u) {
        double x = uniform ? low + u * (high - low) : origin + scaledPosition(u);
        return within(x, low, high);
    }

    /**
     * {@link #sample} minus the mean, without the rounding to the mean's magnitude.
     *
     * @param u in [0, 1)
     */
    public double offset(double u) {
        double o = uniform ? lowOffset + u * (high - low) : originOffset + scaledPosition(u);
        return within(o, lowOffset, highOffset);
    }

    /** The density at x; 0 outside the interval. Greater than 0 at every sampled value, save for the rounding of the value. */
    public double density(double x) {
        if (!(x >= low && x <= high)) {
            return 0;
        }
        return uniform ? 1 / (high - low) : densityAt(x - origin);
    }

    /** The density at the mean plus an offset; 0 outside the interval. */
    public double densityAtOffset(double offset) {
        if (!(offset >= lowOffset && offset <= highOffset)) {
            return 0;
        }
        return uniform ? 1 / (high - low) : densityAt(offset - originOffset);
    }

    private double scaledPosition(double u) {
        double share = unit > 0 ? u : 1 - u;
        return unit * truncated.at(within(share, LEAST, MOST));
    }

    private double densityAt(double fromOrigin) {
        return truncated.density(fromOrigin * perUnit) * perDeviation;
    }

    /** As Math.min and Math.max would have it, but a processor need not wait for it. */
    private static double within(double x, double low, double high) {
        if (x < low) {
            return low;
        }
        return x > high ? high : x;
    }
}

package enlightenment.sampling;

/**
 * A {@link Distribution} with a given mean and standard deviation, truncated to an interval and normalised there. Mutable, not
 * for use by several threads at once, allocation free.
 *
 * <p>Sampling is by inversion, so low-discrepancy numbers stay stratified. Sampling and density agree to about 1e-12, wherever
 * the mean lies, so that the weights f/density of an importance sampler are unbiased to that order. The mean may lie far
 * outside: a normal proposal then falls off from the end of the interval as its tail does. If the family has no density in the
 * interval at all (only the linear one can), the proposal is uniform.
 *
 * <p>Deviations may be far below the rounding of the mean: {@link #offset} gives values relative to the mean, and
 * {@link #densityAtOffset} their density. Use this pair unless the deviation is well above the rounding of the values.
 */
public final class Proposal {
    /** Uniform numbers are clamped to these: at 0 and 1 an infinite interval has no value. */
    private static final double MIN_UNIFORM = 0x1p-54;

    private static final double MAX_UNIFORM = 1 - 0x1p-53;

    /** Distances are clamped to this many deviations: there all of the density lies within rounding of the interval's end. */
    private static final double MAX_DISTANCE = 0x1p500;

    private final Distribution family;
    private final Truncated truncated;
    private double mean;
    private double low;
    private double high;
    private double lowOffset;
    private double highOffset;

    /** The origin of the truncated density's positions, its offset from the mean, and the signed unit of positions. */
    private double origin;

    private double originOffset;
    private double unit;
    private double perUnit;
    private double perDeviation;
    private boolean uniform;

    /** Makes a proposal of this family, standardised and not truncated until {@link #set} is called. */
    public Proposal(Distribution family) {
        this.family = family;
        truncated = Truncated.of(family);
        set(0, 1, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** The family of the density. */
    public Distribution family() {
        return family;
    }

    /**
     * Sets mean, deviation and interval.
     *
     * @param mean of the family before truncation; finite, need not lie in the interval
     * @param deviation of the family before truncation; finite and greater than 0; densities do not overflow or underflow from
     *     1e-300 to 1e300
     * @param low the lower end of the interval, may be infinite
     * @param high the upper end of the interval, greater than the lower one, may be infinite
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
        double distance = Math.min(Math.abs(originOffset) / deviation, MAX_DISTANCE);
        uniform = !truncated.beyond(distance, (high - low) / deviation);
        if (uniform && high - low == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "no density within " + low + ".." + high + ", which is too long for a uniform one");
        }
    }

    /**
     * The quantile u of the proposal.
     *
     * @param u in [0, 1)
     * @return a value within the interval, non-decreasing in u
     */
    public double sample(double u) {
        double x = uniform ? low + u * (high - low) : origin + scaledPosition(u);
        return clamp(x, low, high);
    }

    /**
     * {@link #sample} minus the mean, without the rounding to the mean's magnitude.
     *
     * @param u in [0, 1)
     */
    public double offset(double u) {
        double o = uniform ? lowOffset + u * (high - low) : originOffset + scaledPosition(u);
        return clamp(o, lowOffset, highOffset);
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
        return unit * truncated.at(clamp(share, MIN_UNIFORM, MAX_UNIFORM));
    }

    private double densityAt(double fromOrigin) {
        return truncated.density(fromOrigin * perUnit) * perDeviation;
    }

    /** x clamped to low..high; branches, unlike Math.min and Math.max, need not wait for the result. */
    private static double clamp(double x, double low, double high) {
        if (x < low) {
            return low;
        }
        return x > high ? high : x;
    }
}

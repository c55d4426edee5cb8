package enlightenment.sampling;

/**
 * Count, mean and variance of values that come one by one, without storing them. Not safe for use by several threads:
 * give each its own, and {@link #merge} them.
 *
 * <p>Welford's method ("Note on a method for calculating corrected sums of squares and products", 1962) on offsets from
 * the first value, so that values that differ only in their last digits lose none of those; merging after Chan, Golub and
 * LeVeque ("Updating formulae and a pairwise algorithm for computing sample variances", 1979). The variance is never
 * negative. Its relative error is about that of a sum of n terms, as long as the standard deviation is large compared
 * with the rounding of the values themselves.
 *
 * <p>The squares of the values' differences must be within the range of doubles: differences below about 1e-154 vanish,
 * and beyond about 1e154 variance and deviation become infinite.
 */
public final class RunningStatistics {
    private long count;

    /** The first value: all others are taken relative to it. */
    private double reference;

    /** The mean of the offsets from the reference. */
    private double meanOffset;

    /** The sum of squared differences from the mean. */
    private double squares;

    /** Statistics of no values. */
    public RunningStatistics() {}

    /**
     * Adds a value.
     *
     * @throws IllegalArgumentException if it is infinite or NaN
     */
    public void add(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("a value must be finite, not " + value);
        }
        if (count == 0) {
            reference = value;
        }
        count++;
        double offset = value - reference;
        double difference = offset - meanOffset;
        meanOffset += difference / count;
        squares += difference * (offset - meanOffset);
    }

    /** Adds all values of the other, which stays as it is. The order of merging changes results in the last digits only. */
    public void merge(RunningStatistics other) {
        if (other.count == 0) {
            return;
        }
        if (count == 0) {
            reference = other.reference;
        }
        long all = count + other.count;
        double share = (double) other.count / all;
        double difference = (other.reference - reference) + (other.meanOffset - meanOffset);
        squares += other.squares + difference * difference * count * share;
        meanOffset += difference * share;
        count = all;
    }

    /** The number of values. */
    public long count() {
        return count;
    }

    /** The mean of the values; 0 if there are none. */
    public double mean() {
        return reference + meanOffset;
    }

    /** The unbiased estimate of the variance: squared differences from the mean over n − 1; 0 for fewer than two values. */
    public double variance() {
        return count < 2 ? 0 : squares / (count - 1);
    }

    /** The square root of {@link #variance}. */
    public double standardDeviation() {
        return Math.sqrt(variance());
    }

    /** The standard deviation of the mean itself, if the values are independent; 0 for fewer than two values. */
    public double standardError() {
        return count < 2 ? 0 : Math.sqrt(variance() / count);
    }
}

package enlightenment.measure.trade;

import java.util.Arrays;
import java.util.Collection;

/**
 * Repeated measurements of one quantity, summed up without assuming a distribution.
 *
 * @param low the smallest
 * @param median the middle value, or the mean of the middle two: one disturbed run in three does not move it
 * @param high the largest
 * @param count how many there were, at least 1
 */
public record Spread(double low, double median, double high, int count) {
    /**
     * The spread of some values.
     *
     * @throws IllegalArgumentException if there are none, or one is NaN
     */
    public static Spread of(Collection<Double> values) {
        double[] sorted =
                values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        if (sorted.length == 0 || Arrays.stream(sorted).anyMatch(Double::isNaN)) {
            throw new IllegalArgumentException("needs values that are numbers, not " + values);
        }
        int n = sorted.length;
        double median = n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
        return new Spread(sorted[0], median, sorted[n - 1], n);
    }

    /** The spread of a single value. */
    public static Spread of(double value) {
        return new Spread(value, value, value, 1);
    }

    /** All three values multiplied by a factor greater than 0. */
    public Spread times(double factor) {
        return new Spread(low * factor, median * factor, high * factor, count);
    }
}

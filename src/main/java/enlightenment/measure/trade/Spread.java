package enlightenment.measure.trade;

import java.util.Arrays;
import java.util.Collection;

/**
 * Summary of repeated measurements of one quantity, without an assumed distribution.
 *
 * @param low the smallest value
 * @param median the middle value, or the mean of the middle two: one disturbed run in three does not move it
 * @param high the largest value
 * @param count number of measurements, at least 1
 */
public record Spread(double low, double median, double high, int count) {
    /**
     * The spread of some values.
     *
     * @throws IllegalArgumentException if there are no values, or one is NaN
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

    /** The spread with all three values multiplied by a factor greater than 0. */
    public Spread times(double factor) {
        return new Spread(low * factor, median * factor, high * factor, count);
    }
}

package enlightenment.measure;

import java.util.Arrays;
import java.util.Collection;

/**
 * Some measurements of one thing.
 *
 * @param low the smallest
 * @param median the middle one, or the mean of the middle two: a neighbour who disturbs one run in three does not move it
 * @param high the largest
 * @param count how many there are, at least 1
 */
public record Spread(double low, double median, double high, int count) {
    /** The spread of at least one value; none may be NaN. */
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

    /** A single value. */
    public static Spread of(double value) {
        return new Spread(value, value, value, 1);
    }

    /** All three times a factor, which must be positive. */
    public Spread times(double factor) {
        return new Spread(low * factor, median * factor, high * factor, count);
    }
}

package enlightenment.physical;

import java.util.Arrays;

/**
 * A mean and how far it may be off.
 *
 * @param mean of the numbers
 * @param error the standard error of that mean
 */
record Statistics(double mean, double error) {
    static Statistics of(double... numbers) {
        double mean = Arrays.stream(numbers).average().orElseThrow();
        double squares =
                Arrays.stream(numbers).map(v -> (v - mean) * (v - mean)).sum();
        return new Statistics(mean, Math.sqrt(squares / (numbers.length - 1) / numbers.length));
    }
}

package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;

/** Pearson's test of counts against what is expected of them. */
public final class ChiSquare {
    private ChiSquare() {}

    /**
     * Fails if the counts are so far from these expectations, of at least 5 each, that a right sampler would be in one of a million
     * tests: by Wilson and Hilferty's cube root, which is close to normal.
     */
    public static void check(double[] expected, int[] counts, String what) {
        double sum = 0;
        for (int k = 0; k < counts.length; k++) {
            assertTrue(expected[k] >= 5, what + ": too few in cell " + k);
            sum += (counts[k] - expected[k]) * (counts[k] - expected[k]) / expected[k];
        }
        double degrees = counts.length - 1;
        double spread = 2 / (9 * degrees);
        double deviations = (Math.cbrt(sum / degrees) - (1 - spread)) / Math.sqrt(spread);
        assertTrue(deviations < 4.75, what + ": chi² " + sum + " of " + degrees + " degrees of freedom");
    }

    /** The same where all counts are expected to be alike. */
    public static void checkEven(int[] counts, String what) {
        double sum = 0;
        for (int c : counts) {
            sum += c;
        }
        double[] expected = new double[counts.length];
        Arrays.fill(expected, sum / counts.length);
        check(expected, counts, what);
    }
}

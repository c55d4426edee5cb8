package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;

/**
 * Pearson's test that directions are sampled with the density that is claimed for them, over cells of the sphere; what is rejected is a
 * cell too, so that the density's integral is tested. Cells of which less than five samples are expected are pooled (as in the tests of
 * Nori, Mitsuba and pbrt).
 */
public final class DirectionChiSquare {
    /** A sampler of directions and the density per solid angle that it claims. */
    public interface Sampled {
        /**
         * Samples a direction from three numbers.
         *
         * @return false if it is rejected
         */
        boolean sample(double u, double v, double choice, double[] out);

        double pdf(double x, double y, double z);
    }

    /** One of 20,000: Šidák's level for a chance of failure of 1 % in all, of 200 tests. */
    private static final double DEVIATIONS = 3.89;

    private DirectionChiSquare() {}

    /**
     * Fails if samples and density do not fit.
     *
     * @return the integral of the density
     */
    public static double check(Sampled sampled, SphereCells cells, int samples, long seed, String what) {
        double[] expected = cells.integrals(sampled::pdf, 0.1 / samples);
        int[] counts = new int[cells.count() + 1];
        SplittableRandom random = new SplittableRandom(seed);
        double[] d = new double[3];
        for (int k = 0; k < samples; k++) {
            boolean found = sampled.sample(random.nextDouble(), random.nextDouble(), random.nextDouble(), d);
            counts[found ? cells.cell(d[0], d[1], d[2]) : cells.count()]++;
        }
        double total = 0;
        for (double e : expected) {
            total += e;
        }
        assertTrue(total <= 1 + 1e-3, what + ": the density's integral is " + total);
        double deviations = deviations(expected, Math.max(1 - total, 0), counts, samples);
        assertTrue(deviations < DEVIATIONS, what + ": chi² is off by " + deviations + " deviations");
        return total;
    }

    /** The chance of such counts in standard deviations of a normal variable: by Wilson and Hilferty's cube root. */
    private static double deviations(double[] expected, double rejected, int[] counts, int samples) {
        double sum = 0;
        double pooledExpected = 0;
        double pooledCount = 0;
        int cells = 0;
        for (int k = 0; k < counts.length; k++) {
            double e = samples * (k < expected.length ? expected[k] : rejected);
            if (e < 5) {
                pooledExpected += e;
                pooledCount += counts[k];
            } else {
                sum += (counts[k] - e) * (counts[k] - e) / e;
                cells++;
            }
        }
        if (pooledExpected >= 5) {
            sum += (pooledCount - pooledExpected) * (pooledCount - pooledExpected) / pooledExpected;
            cells++;
        } else {
            assertTrue(pooledCount < 30, pooledCount + " samples where " + pooledExpected + " are expected");
        }
        assertTrue(cells > 10, "too few cells with samples: " + cells);
        double degrees = cells - 1;
        double spread = 2 / (9 * degrees);
        return (Math.cbrt(sum / degrees) - (1 - spread)) / Math.sqrt(spread);
    }
}

package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The test that the other tests rely on. */
class WelchTest {
    /** Two samples of three whose difference is t standard errors: ν = 4. */
    private static Welch apart(double t) {
        // Variance 1 each, so the standard error is √(1/3 + 1/3).
        double d = t * Math.sqrt(2.0 / 3);
        return Welch.of(new double[] {d - 1, d, d + 1}, new double[] {-1, 0, 1});
    }

    @Test
    void theProbabilityIsStudents() {
        // With four degrees of freedom the tail has a closed form: P(|T| > t) = 1 − s (3 − s²)/2, s = t/√(4 + t²).
        for (double t : new double[] {0, 0.5, 1, 2.776, 8}) {
            double s = t / Math.sqrt(4 + t * t);
            assertEquals(1 - s * (3 - s * s) / 2, apart(t).probability(), 1e-9);
        }
    }

    @Test
    void sidaksLevelIsExact() {
        assertEquals(0.01, 1 - Math.pow(1 - Welch.sidak(0.01, 19), 19), 1e-15);
    }

    @Test
    void equalMeansAreRejectedAsOftenAsTheLevelSays() {
        Random random = new Random(1);
        int runs = 2000;
        int rejected = 0;
        for (int r = 0; r < runs; r++) {
            double[] a = random.doubles(40).map(x -> x * x).toArray();
            double[] b = random.doubles(64).map(x -> 1.0 / 3 + 4 * (x - 0.5)).toArray();
            rejected += Welch.of(a, b).probability() < 0.05 ? 1 : 0;
        }
        // 100 expected, deviation √(2000 · 0.05 · 0.95) = 9.7; four of them.
        assertEquals(100, rejected, 39);
    }

    @Test
    void samplesWithoutNoiseAreEqualUpToRounding() {
        double[] a = new double[64];
        double[] b = new double[64];
        Arrays.fill(a, 0.3);
        Arrays.fill(b, 0.1 + 0.2);
        assertTrue(Welch.of(a, b).probability() > 0.9);
        Arrays.fill(b, 0.3 + 1e-9);
        assertTrue(Welch.of(a, b).probability() < 1e-9);
    }
}

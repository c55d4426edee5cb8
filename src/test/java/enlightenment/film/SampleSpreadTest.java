package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.sampling.Hash;
import enlightenment.sampling.Sobol;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SampleSpreadTest {
    /** All values of a sample are equally likely: 0 or 1, with every combination of n of them counted once. */
    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8, 16})
    void ofIndependentSamplesTheHalvesGiveTheFallOfTheVarianceExactly(int n) {
        SampleSpread spread = new SampleSpread();
        double halves = 0;
        double quarters = 0;
        for (int bits = 0; bits < 1 << n; bits++) {
            spread.begin(n);
            for (int s = 0; s < n; s++) {
                double v = bits >> s & 1;
                spread.add(v, v, v);
            }
            halves += spread.halves();
            quarters += spread.quarters();
        }
        double all = 1 << n;
        // A coin has variance 1/4, the mean of n of them 1/(4n).
        assertEquals(1.0 / (4 * n / 2) - 1.0 / (4 * n), halves / all, 1e-15);
        assertEquals(n < 4 ? 0 : 1.0 / (4 * n / 4) - 1.0 / (4 * n / 2), quarters / all, 1e-15);
    }

    /** One coin in each half: the first half takes one value, the second the other, so that the mean has no error at all. */
    @Test
    void ofSamplesThatDependOnEachOtherItIsExactToo() {
        SampleSpread spread = new SampleSpread();
        spread.begin(2);
        spread.add(0, 0, 0);
        spread.add(1, 1, 1);
        // V(1) = 1/4, V(2) = 0.
        assertEquals(0.25, spread.halves());
    }

    @ParameterizedTest
    @CsvSource({"4, 0.3", "8, 0.7", "16, 0.45"})
    void ofTheSequenceThatPixelsUseItIsTheFallOfTheVariance(int n, double slope) {
        int runs = 40_000;
        SampleSpread spread = new SampleSpread();
        double[] variance = new double[3];
        double halves = 0;
        double quarters = 0;
        for (int r = 0; r < runs; r++) {
            long seed = Hash.of(r, n);
            spread.begin(n);
            double sum = 0;
            for (int s = 0; s < n; s++) {
                // An edge across the pixel: its share is 1/2 by symmetry.
                double v = Sobol.y(s, seed) - 0.5 > slope * (Sobol.x(s, seed) - 0.5) ? 1 : 0;
                spread.add(v, v, v);
                sum += v;
                if (s + 1 == n / 4 || s + 1 == n / 2 || s + 1 == n) {
                    int level = s + 1 == n ? 2 : s + 1 == n / 2 ? 1 : 0;
                    variance[level] += (sum / (s + 1) - 0.5) * (sum / (s + 1) - 0.5) / runs;
                }
            }
            halves += spread.halves() / runs;
            quarters += spread.quarters() / runs;
        }
        // Squares of numbers of this size: their deviation is about their mean, over √runs; four of them.
        double tolerance = 4 * 1.5 / Math.sqrt(runs);
        assertEquals(variance[1] - variance[2], halves, tolerance * variance[1]);
        assertEquals(variance[0] - variance[1], quarters, tolerance * variance[0]);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 5, 6, 7, 9, 100})
    void forOtherNumbersOfIndependentSamplesTheHalvesAreNotLessThanTheVariance(int n) {
        Random random = new Random(n);
        SampleSpread spread = new SampleSpread();
        int runs = 40_000;
        double sum = 0;
        for (int r = 0; r < runs; r++) {
            spread.begin(n);
            for (int s = 0; s < n; s++) {
                double v = random.nextGaussian();
                spread.add(v, 0, -v);
            }
            sum += spread.halves();
        }
        // Two of three components vary. Two parts of a and b samples give (1/a + 1/b)/4 ≥ 1/(a + b), equal for a = b;
        // with
        // n < 10 samples one part has at most twice the other: (1 + 1/2)/4 over 1/3.
        double variance = 2.0 / 3 / n;
        double ratio = sum / runs / variance;
        double noise = 4 * Math.sqrt(2.0 / runs);
        assertEquals(1.06, ratio, 0.065 + noise);
    }

    @Test
    void aSingleSampleTellsNothing() {
        SampleSpread spread = new SampleSpread();
        spread.begin(1);
        spread.add(1, 2, 3);
        assertEquals(0, spread.halves());
        assertEquals(0, spread.quarters());
    }

    @Test
    void whatWasBeforeIsForgotten() {
        SampleSpread spread = new SampleSpread();
        spread.begin(4);
        for (int s = 0; s < 4; s++) {
            spread.add(s, s * s, 1);
        }
        spread.begin(4);
        for (int s = 0; s < 4; s++) {
            spread.add(7, 7, 7);
        }
        assertEquals(0, spread.halves());
        assertEquals(0, spread.quarters());
    }
}

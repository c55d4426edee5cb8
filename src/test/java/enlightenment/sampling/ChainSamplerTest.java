package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Sampler.Purpose;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A Markov chain's numbers: uniform, moved symmetrically, restored and repeated to the last bit. */
class ChainSamplerTest {
    private static final double SHORTEST = 1.0 / 1024;
    private static final double LONGEST = 1.0 / 64;

    /** All that paths of three bounces ask for. */
    private static double[] numbers(ChainSampler chain) {
        double[] all = new double[3 * (3 + 2 * Purpose.values().length) + 2];
        double[] point = new double[2];
        int n = 0;
        all[n++] = chain.filmX();
        all[n++] = chain.filmY();
        for (int bounce = 0; bounce < 3; bounce++) {
            all[n++] = chain.unit(bounce, Purpose.ROULETTE);
            for (Purpose purpose : Purpose.values()) {
                chain.pair(bounce, purpose, point);
                all[n++] = point[0];
                all[n++] = point[1];
            }
            chain.lightPoints(1, bounce, 1);
            all[n++] = chain.lightX(0);
            all[n++] = chain.lightY(0);
        }
        return all;
    }

    private static void assertSame(double[] expected, double[] actual) {
        for (int k = 0; k < expected.length; k++) {
            assertEquals(Double.doubleToLongBits(expected[k]), Double.doubleToLongBits(actual[k]), "number " + k);
        }
    }

    @Test
    void aRejectedStepLeavesNoTrace() {
        ChainSampler chain = new ChainSampler(0.3);
        chain.begin(5, 2);
        SplittableRandom random = new SplittableRandom(1);
        int changed = 0;
        for (int step = 0; step < 500; step++) {
            double[] before = numbers(chain);
            chain.propose();
            double[] proposed = numbers(chain);
            changed += proposed[3] != before[3] ? 1 : 0;
            if (random.nextBoolean()) {
                chain.accept();
                assertSame(proposed, numbers(chain));
            } else {
                chain.reject();
                assertSame(before, numbers(chain));
            }
        }
        // Half of the small steps move the place on the film alone.
        assertEquals(0.65 * 500, changed, 4 * Math.sqrt(0.65 * 0.35 * 500));
    }

    @Test
    void whatIsAskedForAndWhenChangesNothing() {
        ChainSampler eager = new ChainSampler(0.05);
        ChainSampler lazy = new ChainSampler(0.05);
        eager.begin(9, 1);
        lazy.begin(9, 1);
        SplittableRandom random = new SplittableRandom(2);
        for (int step = 0; step < 2_000; step++) {
            eager.propose();
            lazy.propose();
            numbers(eager);
            if (random.nextInt(3) > 0) {
                eager.accept();
                lazy.accept();
            } else {
                eager.reject();
                lazy.reject();
            }
            if (step % 400 == 399) {
                assertSame(numbers(eager), numbers(lazy));
            }
        }
    }

    @Test
    void aChainIsRepeatedByItsSeedNumberAndDecisions() {
        ChainSampler used = new ChainSampler(0.3);
        ChainSampler fresh = new ChainSampler(0.3);
        used.begin(1, 1);
        for (int step = 0; step < 100; step++) {
            used.propose();
            numbers(used);
            used.accept();
        }
        double[] other = numbers(used);
        used.begin(1, 2);
        fresh.begin(1, 2);
        for (int step = 0; step < 300; step++) {
            used.propose();
            fresh.propose();
            assertEquals(fresh.isLarge(), used.isLarge());
            assertSame(numbers(fresh), numbers(used));
            if (fresh.filmX() < 0.6) {
                used.accept();
                fresh.accept();
            } else {
                used.reject();
                fresh.reject();
            }
        }
        assertNotEquals(other[0], numbers(used)[0]);
    }

    @Test
    void aSmallStepIsSymmetricLogarithmicAndWrapsAround() {
        int[] lengths = new int[16];
        int[] sides = new int[2];
        int wrapped = 0;
        double[] lengthsRight = new double[2];
        ChainSampler chain = new ChainSampler(0x1p-40);
        int moved = 0;
        for (int k = 0; k < 80_000; k++) {
            chain.begin(3, k);
            double before = chain.unit(1, Purpose.CHOICE);
            double onFilm = chain.filmY();
            chain.propose();
            double after = chain.unit(1, Purpose.CHOICE);
            assertTrue(after >= 0 && after < 1);
            checkOnFilm(onFilm, chain.filmY());
            if (after == before) {
                continue;
            }
            moved++;
            double d = after - before;
            wrapped += Math.abs(d) > 0.5 ? 1 : 0;
            d -= Math.rint(d);
            double length = Math.abs(d);
            assertTrue(length >= SHORTEST * (1 - 1e-12) && length <= LONGEST * (1 + 1e-12), "length " + length);
            // ξ of s₂·exp(−ξ ln(s₂/s₁)).
            double xi = Math.log(LONGEST / length) / Math.log(LONGEST / SHORTEST);
            lengths[Math.min((int) (16 * Math.max(xi, 0)), 15)]++;
            sides[d > 0 ? 1 : 0]++;
            lengthsRight[d > 0 ? 1 : 0] += length;
        }
        ChiSquare.checkEven(lengths, "lengths");
        ChiSquare.checkEven(sides, "sides");
        assertEquals(40_000, moved, 4 * 0.5 * Math.sqrt(80_000));
        assertEquals(1, lengthsRight[0] / lengthsRight[1], 0.03);
        // The mean length is (s₂ − s₁)/ln(s₂/s₁), and as large is the chance to pass the end.
        double mean = (LONGEST - SHORTEST) / Math.log(LONGEST / SHORTEST);
        assertEquals(moved * mean, wrapped, 4 * Math.sqrt(moved * mean));
    }

    /** The place on the film always moves, and four times as far. */
    private static void checkOnFilm(double before, double after) {
        double length = Math.abs(after - before - Math.rint(after - before));
        assertTrue(
                length >= 4 * SHORTEST * (1 - 1e-12) && length <= 4 * LONGEST * (1 + 1e-12), "on the film " + length);
    }

    @Test
    void severalChainsBeginWithTheSameNumbersAndGoDifferentWays() {
        ChainSampler one = new ChainSampler(0.3);
        ChainSampler other = new ChainSampler(0.3);
        one.begin(7, 3, 1);
        one.at(0.25, 0.625);
        other.begin(7, 3, 2);
        other.at(0.25, 0.625);
        assertEquals(0.25, one.filmX());
        assertEquals(0.625, one.filmY());
        assertSame(numbers(one), numbers(other));
        one.propose();
        other.propose();
        assertNotEquals(one.decision(), other.decision());
        assertNotEquals(one.filmX(), other.filmX());
        one.reject();
        assertEquals(0.25, one.filmX());
    }

    @Test
    void whetherAStepIsMadeIsDecidedEvenly() {
        int[] counts = new int[50];
        ChainSampler chain = new ChainSampler(0.3);
        for (int k = 0; k < 200; k++) {
            chain.begin(11, k);
            for (int step = 0; step < 100; step++) {
                chain.propose();
                counts[(int) (50 * chain.decision())]++;
                chain.reject();
            }
        }
        ChiSquare.checkEven(counts, "decisions");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0x1p-40, 1})
    void numbersStayUniformWhateverIsAcceptedWithoutLookingAtThem(double largeShare) {
        int[] single = new int[50];
        int[] together = new int[64];
        double[] point = new double[2];
        ChainSampler chain = new ChainSampler(largeShare);
        for (int k = 0; k < 20_000; k++) {
            chain.begin(17, k);
            for (int step = 0; step < 6; step++) {
                chain.propose();
                if ((k + step) % 3 == 0) {
                    chain.reject();
                } else {
                    chain.accept();
                }
            }
            single[(int) (50 * chain.unit(4, Purpose.ROULETTE))]++;
            chain.pair(0, Purpose.DIRECTION, point);
            together[8 * (int) (8 * point[0]) + (int) (8 * point[1])]++;
        }
        ChiSquare.checkEven(single, "single numbers");
        ChiSquare.checkEven(together, "pairs");
    }

    /** With accepting by the ratio of a target the states are distributed like the target: here x²·(1 − y), whose mean is (3/4, 1/3). */
    @Test
    void metropolisFindsItsTarget() {
        int chains = 200;
        int steps = 500;
        RunningStatistics meansOfX = new RunningStatistics();
        RunningStatistics meansOfY = new RunningStatistics();
        int large = 0;
        ChainSampler chain = new ChainSampler(0.3);
        SplittableRandom random = new SplittableRandom(8);
        for (int c = 0; c < chains; c++) {
            chain.begin(23, c);
            double x = chain.filmX();
            double y = chain.filmY();
            double sumX = 0;
            double sumY = 0;
            for (int step = -50; step < steps; step++) {
                chain.propose();
                large += chain.isLarge() ? 1 : 0;
                double px = chain.filmX();
                double py = chain.filmY();
                if (random.nextDouble() * (x * x * (1 - y)) < px * px * (1 - py)) {
                    chain.accept();
                    x = px;
                    y = py;
                } else {
                    chain.reject();
                }
                sumX += step < 0 ? 0 : x;
                sumY += step < 0 ? 0 : y;
            }
            meansOfX.add(sumX / steps);
            meansOfY.add(sumY / steps);
        }
        assertEquals(0.75, meansOfX.mean(), 4 * meansOfX.standardError());
        assertEquals(1.0 / 3, meansOfY.mean(), 4 * meansOfY.standardError());
        assertTrue(meansOfX.standardError() < 0.005, "too noisy to tell");
        int all = chains * (steps + 50);
        assertEquals(0.3 * all, large, 4 * Math.sqrt(0.21 * all));
    }

    @Test
    void largeStepsMustHaveAShare() {
        assertThrows(IllegalArgumentException.class, () -> new ChainSampler(0));
        assertThrows(IllegalArgumentException.class, () -> new ChainSampler(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> new ChainSampler(1.5));
    }
}

package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class ProposalTest {
    private record Case(String family, double mean, double deviation, double low, double high) {
        Proposal proposal() {
            Proposal p = new Proposal(Distribution.of(family));
            p.set(mean, deviation, low, high);
            return p;
        }

        /** The smaller of the two lengths over which the density changes. */
        double scale() {
            return Math.min(deviation, high - low);
        }

        double farthestOffset() {
            return Math.max(Math.abs(low - mean), Math.abs(high - mean));
        }
    }

    /** Means within, on the ends and far outside; deviations from far below to far above the interval's length. */
    static List<Case> cases() {
        List<Case> all = new ArrayList<>();
        for (String family : Distribution.NAMES) {
            for (double deviation : new double[] {1e-8, 1e-4, 0.02, 0.125, 1, 30, 200, 1e4, 1e8}) {
                for (double mean : new double[] {0.5, 0.03125, 0, 1, -1e-9, 1.25}) {
                    all.add(new Case(family, mean, deviation, 0, 1));
                }
                for (double distance : new double[] {0.5, 2, 8, 15.9, 16.1, 40, 70, 1e3, 1e9, 1e200}) {
                    all.add(new Case(family, -distance * deviation, deviation, 0, 1));
                    all.add(new Case(family, 1 + distance * deviation, deviation, 0, 1));
                    all.add(new Case(family, -distance * deviation, deviation, 0, Math.min(deviation / 100, 1)));
                }
            }
        }
        return all;
    }

    /** Those cases whose offsets from the mean are doubles fine enough to tell shares of the density apart. */
    static Stream<Case> resolvedCases() {
        return cases().stream().filter(c -> Math.ulp(c.farthestOffset()) < 1e-10 * c.scale());
    }

    private static double share(int i) {
        // Powers of two towards 0, then equal steps, then powers of two towards 1.
        if (i < 40) {
            return Math.scalb(1.0, i - 44);
        }
        return i < 70 ? 0.0625 + (i - 40) * 0.875 / 30 : 1 - Math.scalb(1.0, 66 - i);
    }

    private static final int SHARES = 110;

    @ParameterizedTest
    @MethodSource("resolvedCases")
    void theIntegralOfTheDensityUpToASampleIsTheShareThatGaveIt(Case c) {
        Proposal p = c.proposal();
        double at = p.offset(0);
        double u = 0;
        for (int i = 0; i <= SHARES; i++) {
            double next = i < SHARES ? share(i) : Math.nextDown(1.0);
            double value = p.offset(next);
            assertTrue(value >= at, "grows with the share");
            // The kinks of zeta and linear at the mean end a panel.
            double part = at < 0 && value > 0
                    ? Quadrature.integral(p::densityAtOffset, at, 0, 4)
                            + Quadrature.integral(p::densityAtOffset, 0, value, 4)
                    : Quadrature.integral(p::densityAtOffset, at, value, 4);
            // What the rounding of two offsets as doubles makes of the area between them.
            double rounding = 2 * Math.max(Math.ulp(at), Math.ulp(value)) * p.densityAtOffset(value);
            double from = u;
            assertEquals(next - from, part, 5e-13 + rounding, () -> c + " between " + from + " and " + next);
            at = value;
            u = next;
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everySampleIsInTheIntervalAndHasAFiniteDensityGreaterThanZero(Case c) {
        Proposal p = c.proposal();
        for (int i = 0; i < 500; i++) {
            double u = i == 0 ? 0 : i == 1 ? Math.nextDown(1.0) : Hash.unit(Hash.of(11, i));
            double x = p.sample(u);
            assertTrue(x >= c.low && x <= c.high, () -> c + ": " + x);
            double offset = p.offset(u);
            double density = p.densityAtOffset(offset);
            assertTrue(density > 0 && density < Double.POSITIVE_INFINITY, () -> c + " at " + u + ": " + density);
            double ofValue = p.density(x);
            assertTrue(ofValue > 0 && ofValue < Double.POSITIVE_INFINITY, () -> c + " at " + u + ": " + ofValue);
            assertEquals(x, p.sample(u), "the same bits again");
            assertEquals(density, p.densityAtOffset(p.offset(u)));
        }
        assertEquals(0, p.density(Math.nextDown(c.low)));
        assertEquals(0, p.density(Math.nextUp(c.high)));
        assertEquals(0, p.density(Double.NaN));
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theMeanOfOneOverTheDensityIsTheLengthOfTheInterval(String family) {
        Proposal p = new Proposal(Distribution.of(family));
        int n = 1 << 16;
        for (double mean : new double[] {-0.5, 0, 0.25, 0.5, 1, 2.25}) {
            p.set(mean, 1, 0, 1.5);
            double sum = 0;
            for (int i = 0; i < n; i++) {
                sum += 1 / p.density(p.sample((i + 0.5) / n));
            }
            // The midpoint rule: the error is the second derivative over 24n², and the kink in one cell.
            assertEquals(1.5, sum / n, 1e-8, family + " around " + mean);
        }
    }

    @Test
    void withoutAnIntervalItIsTheFamilyItself() {
        for (String name : Distribution.NAMES) {
            Distribution d = Distribution.of(name);
            Proposal p = new Proposal(d);
            assertEquals(d, p.family());
            for (double u = 0x1p-20; u < 1; u += 0.01171875) {
                double z = d.quantile(u);
                assertEquals(z, p.sample(u), 1e-14 * (1 + Math.abs(z)));
                assertEquals(d.density(z), p.density(z), 1e-14 * d.density(z));
            }
        }
    }

    @Test
    void movingAndStretchingByPowersOfTwoMovesAndStretchesTheSamples() {
        for (String name : Distribution.NAMES) {
            Proposal a = new Case(name, 0.25, 0.5, -0.5, 1).proposal();
            Proposal b = new Case(name, 0x1p-902, 0x1p-901, -0x1p-901, 0x1p-900).proposal();
            Proposal c = new Case(name, -0.25, 0.5, -1, 0.5).proposal();
            for (int i = 1; i < 1024; i++) {
                double u = i / 1024.0;
                assertEquals(a.sample(u), Math.scalb(b.sample(u), 900));
                assertEquals(a.density(a.sample(u)), Math.scalb(b.density(b.sample(u)), -900));
                assertEquals(a.sample(u), -c.sample(1 - u), 1e-15, "mirrored");
            }
        }
    }

    @Test
    void aLinearProposalThatCannotReachTheIntervalIsUniform() {
        Proposal p = new Case("linear", -10, 1, 0, 4).proposal();
        for (double u = 0; u < 1; u += 0.125) {
            assertEquals(4 * u, p.sample(u));
            assertEquals(10 + 4 * u, p.offset(u));
            assertEquals(0.25, p.density(4 * u));
            assertEquals(0.25, p.densityAtOffset(10 + 4 * u));
        }
        assertThrows(IllegalArgumentException.class, () -> p.set(-10, 1, 0, Double.POSITIVE_INFINITY));
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void offsetsAroundABillionWithADeviationOfATenMillionthOfAMillionthStayDistinct(String family) {
        checkDistinctOffsets(family, 50_000);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void aHundredThousandOffsetsAroundABillionStayDistinct(String family) {
        checkDistinctOffsets(family, 100_000);
    }

    private static void checkDistinctOffsets(String family, int n) {
        // N38.
        Proposal p = new Proposal(Distribution.of(family));
        p.set(1e9, 1e-8, 1e9 - 1, 1e9 + 1);
        Set<Double> distinct = new HashSet<>();
        RunningStatistics statistics = new RunningStatistics();
        for (int i = 0; i < n; i++) {
            double offset = p.offset(Hash.unit(Hash.of(38, i)));
            distinct.add(offset);
            statistics.add(offset);
            assertTrue(p.densityAtOffset(offset) > 0);
        }
        assertTrue(distinct.size() >= 0.99 * n, "distinct: " + distinct.size());
        assertEquals(1e-8, statistics.standardDeviation(), 0.02e-8);
        assertEquals(0, statistics.mean(), 4 * statistics.standardError());
    }

    @Test
    void whatIsNoProposalIsRefused() {
        Proposal p = new Proposal(Distribution.of("normal"));
        double inf = Double.POSITIVE_INFINITY;
        double[][] bad = {
            {Double.NaN, 1, 0, 1},
            {inf, 1, 0, 1},
            {0, 0, 0, 1},
            {0, -1, 0, 1},
            {0, Double.NaN, 0, 1},
            {0, inf, 0, 1},
            {0, 1, 1, 1},
            {0, 1, 2, 1},
            {0, 1, Double.NaN, 1},
            {0, 1, 0, Double.NaN}
        };
        for (double[] b : bad) {
            assertThrows(IllegalArgumentException.class, () -> p.set(b[0], b[1], b[2], b[3]));
        }
    }

    private static final int BINS = 65;

    /** Families × places: how many chi² tests there are. */
    static Stream<Case> chiSquareCases() {
        return Distribution.NAMES.stream()
                .flatMap(f -> Stream.of(
                        new Case(f, 0, 1, -2.25, 2.25),
                        new Case(f, 0.25, 0.125, 0, 1),
                        new Case(f, -0.5, 1, 0, 1),
                        new Case(f, 3, 1.5, -1, 1),
                        new Case(f, 0.5, 50, 0, 1)));
    }

    @ParameterizedTest
    @MethodSource("chiSquareCases")
    void samplesFollowTheDensityByChiSquare(Case c) {
        checkChiSquare(c, 50_000, 50);
    }

    @ParameterizedTest
    @Tag("full")
    @MethodSource("chiSquareCases")
    void twoHundredThousandSamplesFollowTheDensityByChiSquare(Case c) {
        checkChiSquare(c, 200_000, 200);
    }

    /** All cases of one size together fail by chance once in a hundred, whatever the size. */
    private static void checkChiSquare(Case c, int n, int panels) {
        Proposal p = c.proposal();
        int[] counts = new int[BINS];
        for (int i = 0; i < n; i++) {
            double x = p.sample(Hash.unit(Hash.of(2024, i)));
            counts[(int) Math.min((x - c.low) / (c.high - c.low) * BINS, BINS - 1)]++;
        }
        double chi2 = 0;
        double rareExpected = 0;
        int rareCount = 0;
        int freedom = -1;
        for (int k = 0; k < BINS; k++) {
            double expected = n * massOfBin(p, c, k, panels);
            rareExpected += expected;
            rareCount += counts[k];
            // Bins of fewer than ten are counted together with the next ones.
            if (rareExpected >= 10) {
                chi2 += (rareCount - rareExpected) * (rareCount - rareExpected) / rareExpected;
                freedom++;
                rareExpected = 0;
                rareCount = 0;
            }
        }
        assertTrue(rareExpected < 10 && rareCount < 40);
        double alpha = 1 - StrictMath.pow(1 - 0.01, 1.0 / chiSquareCases().count());
        assertTrue(upperTail(chi2, freedom) > alpha, c + ": chi² " + chi2 + " of " + freedom);
    }

    private static double massOfBin(Proposal p, Case c, int k, int panels) {
        double a = c.low + (c.high - c.low) * k / BINS;
        double b = c.low + (c.high - c.low) * (k + 1) / BINS;
        // Fine enough for the kinks at the mean and at the ends of the linear one: 1e-6 of a bin with 200 panels, and
        // as
        // the square of their width, 2e-5 with 50. Chance makes more than a hundredth of a bin's count.
        return Quadrature.integral(p::density, a, b, panels);
    }

    /** The probability of a larger chi²; of one degree less if their number is odd, which is stricter. */
    private static double upperTail(double chi2, int freedom) {
        double x = chi2 / 2;
        double term = StrictMath.exp(-x);
        double sum = 0;
        for (int i = 0; i < freedom / 2; i++) {
            sum += term;
            term *= x / (i + 1);
        }
        return sum;
    }
}

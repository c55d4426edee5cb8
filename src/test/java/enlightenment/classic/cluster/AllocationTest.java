package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Numbers of samples grow with need and with effort; all are powers of two, since their logarithms are what is chosen. */
class AllocationTest {
    /** Of a picture that is nearly all background, so that hardly anything limits the rest of it. */
    private static final double SHARE = 0x1p-20;

    private static final double[] NEEDS = new double[400];

    static {
        for (int k = 1; k < NEEDS.length; k++) {
            NEEDS[k] = Math.pow(2, -40 + k * 0.11);
        }
    }

    @Test
    void moreVarianceNeverMeansFewerSamples() {
        for (double effort : new double[] {1, 77, 1e4, 0x1p40}) {
            Allocation allocation = new Allocation(effort, 1, SHARE);
            for (int k = 1; k < NEEDS.length; k++) {
                assertTrue(allocation.samples(NEEDS[k], 0, 0, 0.5) >= allocation.samples(NEEDS[k - 1], 0, 0, 0.5));
                assertTrue(allocation.samples(0, NEEDS[k], 0, 0.5) >= allocation.samples(0, NEEDS[k - 1], 0, 0.5));
                assertTrue(allocation.samples(0, 0, NEEDS[k], 0.5) >= allocation.samples(0, 0, NEEDS[k - 1], 0.5));
                assertTrue(allocation.lightPoints(NEEDS[k]) >= allocation.lightPoints(NEEDS[k - 1]));
            }
        }
    }

    @Test
    void moreEffortNeverMeansFewerSamples() {
        for (int k = 1; k < NEEDS.length; k++) {
            for (double effort = 1; effort < 0x1p60; effort *= 1.3) {
                Allocation less = new Allocation(effort, 1, SHARE);
                Allocation more = new Allocation(effort * 1.3, 1, SHARE);
                assertTrue(more.samples(NEEDS[k], 0, 0, 0.5) >= less.samples(NEEDS[k], 0, 0, 0.5));
                assertTrue(more.lightPoints(NEEDS[k]) >= less.lightPoints(NEEDS[k]));
            }
        }
    }

    @Test
    void whatNeedsNothingGetsOneSample() {
        Allocation allocation = new Allocation(0x1p64, 1, SHARE);
        assertEquals(0, allocation.samples(0, 0, 0, 0.5));
        assertEquals(0, allocation.lightPoints(0));
    }

    /** Of variances a n^−γ the sum is least, for a given sum of n, where all n^(γ + 1)/a are the same. */
    @Test
    void samplesGrowAsTheLeastErrorWantsIt() {
        Allocation allocation = new Allocation(0x1p30, 1, SHARE);
        // At edges γ is 1.5: a variance 2^(2.5 · 4) times as great gets 2^4 times as many samples.
        int few = allocation.samples(0, 0x1p-10, 0, 0.5);
        assertEquals(few + 4, allocation.samples(0, 1, 0, 0.5));
        // Where the colour is smooth it is 1.85: 2^(2.85 · 20) times as great gets 2^20 times as many.
        Allocation great = new Allocation(0x1p60, 1, SHARE);
        assertEquals(great.samples(0x1p-57, 0, 0, 0.5) + 20, great.samples(1, 0, 0, 0.5));
    }

    @Test
    void samplesStayInRangeWhateverTheNeed() {
        Allocation allocation = new Allocation(0x1p64, 1, SHARE);
        for (double need : new double[] {1e300, Double.POSITIVE_INFINITY, Double.MIN_VALUE}) {
            int samples = allocation.samples(need, need, need, 0.5);
            int points = allocation.lightPoints(need);
            assertTrue(samples >= 0 && samples <= 24);
            assertTrue(points >= 0 && points - samples <= 6, points + " points of " + samples + " samples");
        }
    }

    /** Evenly spaced rays with a quarter of the samples would be no better anywhere, but for rounding to powers of two. */
    @Test
    void aShareOfTheSamplesGoesEverywhere() {
        for (double samples = 1; samples < 1e6; samples *= 1.37) {
            Allocation allocation = new Allocation(1, samples, SHARE);
            int least = allocation.samples(0, Double.MIN_VALUE, 0, 0.5);
            assertTrue(1 << least > samples / 8, samples + " samples, at least 2^" + least);
            assertTrue(least == 0 || 1 << least <= samples / 4, samples + " samples, at least 2^" + least);
            assertEquals(least, Allocation.leastSamples(samples));
        }
    }

    /** Where all pixels need the same, their numbers of samples need not all double at once. */
    @Test
    void anyNumberInBetweenCanBeSpentOnPixelsThatNeedTheSame() {
        double before = 0;
        for (double effort = 0x1p20; effort < 0x1p28; effort *= 1.01) {
            Allocation allocation = new Allocation(effort, 1, SHARE);
            double mean = 0;
            for (int k = 0; k < 1000; k++) {
                mean += (1 << allocation.samples(0, 0x1p-10, 0, k / 1000.0)) / 1000.0;
            }
            assertTrue(mean >= before && (before == 0 || mean < 1.06 * before), before + " then " + mean);
            before = mean;
        }
        assertTrue(before > 100, before + " samples");
    }

    /** 64 times the mean of what shows something: where half of the picture does, that is twice the mean of all. */
    @Test
    void noPixelGetsMoreThanSomeMultipleOfTheMean() {
        for (double samples = 4; samples < 1e4; samples *= 2) {
            assertEquals(64 * samples, 1 << new Allocation(0x1p64, samples, 1).samples(0, 1, 0, 0.5));
            assertEquals(128 * samples, 1 << new Allocation(0x1p64, samples, 0.5).samples(0, 1, 0, 0.5));
        }
    }
}

package enlightenment.method.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Numbers of samples grow with need and with effort; all are powers of two, since their logarithms are what is chosen. */
class AllocationTest {
    private static final double[] NEEDS = new double[400];

    static {
        for (int k = 1; k < NEEDS.length; k++) {
            NEEDS[k] = Math.pow(2, -40 + k * 0.11);
        }
    }

    @Test
    void moreVarianceNeverMeansFewerSamples() {
        for (double effort : new double[] {1, 77, 1e4, 0x1p40}) {
            Allocation allocation = new Allocation(effort);
            for (int k = 1; k < NEEDS.length; k++) {
                assertTrue(allocation.samples(NEEDS[k], 0, 0) >= allocation.samples(NEEDS[k - 1], 0, 0));
                assertTrue(allocation.samples(0, NEEDS[k], 0) >= allocation.samples(0, NEEDS[k - 1], 0));
                assertTrue(allocation.samples(0, 0, NEEDS[k]) >= allocation.samples(0, 0, NEEDS[k - 1]));
                assertTrue(allocation.lightPoints(NEEDS[k]) >= allocation.lightPoints(NEEDS[k - 1]));
            }
        }
    }

    @Test
    void moreEffortNeverMeansFewerSamples() {
        for (int k = 1; k < NEEDS.length; k++) {
            for (double effort = 1; effort < 0x1p60; effort *= 1.3) {
                Allocation less = new Allocation(effort);
                Allocation more = new Allocation(effort * 1.3);
                assertTrue(more.samples(NEEDS[k], 0, 0) >= less.samples(NEEDS[k], 0, 0));
                assertTrue(more.lightPoints(NEEDS[k]) >= less.lightPoints(NEEDS[k]));
            }
        }
    }

    @Test
    void whatNeedsNothingGetsOneSample() {
        Allocation allocation = new Allocation(0x1p64);
        assertEquals(0, allocation.samples(0, 0, 0));
        assertEquals(0, allocation.lightPoints(0));
    }

    /** Of variances a n^−γ the sum is least, for a given sum of n, where all n^(γ + 1)/a are the same. */
    @Test
    void samplesGrowAsTheLeastErrorWantsIt() {
        Allocation allocation = new Allocation(0x1p30);
        // At edges γ is 1.5: a variance 2^(2.5 · 4) times as great gets 2^4 times as many samples.
        int few = allocation.samples(0, 0x1p-10, 0);
        assertEquals(few + 4, allocation.samples(0, 1, 0));
        // Where the colour is smooth it is 1.85: 2^(2.85 · 20) times as great gets 2^20 times as many.
        Allocation great = new Allocation(0x1p60);
        assertEquals(great.samples(0x1p-57, 0, 0) + 20, great.samples(1, 0, 0));
    }

    @Test
    void samplesStayInRangeWhateverTheNeed() {
        Allocation allocation = new Allocation(0x1p64);
        for (double need : new double[] {1e300, Double.POSITIVE_INFINITY, Double.MIN_VALUE}) {
            int samples = allocation.samples(need, need, need);
            int points = allocation.lightPoints(need);
            assertTrue(samples >= 0 && samples <= 24);
            assertTrue(points >= 0 && points - samples <= 6, points + " points of " + samples + " samples");
        }
    }
}

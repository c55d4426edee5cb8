package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.method.cluster.BlockLimits;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a block takes stays within its limits, whatever it needs. */
class BlockAllocationTest {
    private static final Block BLOCK = new Block(16, 8, 8, 8);
    private static final int RAYS = 81;
    private static final double SAMPLES = 16;

    /** Of a picture of so many blocks all of which show something. */
    private static BlockAllocation allocation(double effort, int blocks) {
        return new BlockAllocation(effort, SAMPLES, 1, BlockLimits.ofFew(SAMPLES, blocks));
    }

    /** Needs of all orders of magnitude between these powers of two. */
    private static SampleDemand needs(long seed, double from, double to) {
        Random random = new Random(seed);
        SampleDemand needs = new SampleDemand();
        for (int k = 0; k < needs.edge.length; k++) {
            needs.edge[k] = Math.pow(2, from + (to - from) * random.nextDouble());
        }
        return needs;
    }

    /** Camera rays per pixel, counted pixel by pixel. */
    private static double taken(Allocation allocation, SampleDemand needs) {
        double sum = RAYS;
        for (int k = 0; k < 64; k++) {
            double dither = Dither.at(BLOCK.x() + k % 8, BLOCK.y() + k / 8);
            sum += 1 << allocation.samples(needs.film[k], needs.edge[k], needs.light[k], dither);
        }
        return sum / 64;
    }

    /**
     * Of needs within a factor of 16 the numbers of samples are within one of 16^(1/2.5) = 3, and are rounded to powers of two: none is more
     * than 8 times the mean. A step is of one pixel of 64 that takes twice as many; the nearer end of it is taken.
     */
    @ParameterizedTest
    @ValueSource(ints = {-60, -40, -27, -20, -10, 0})
    void aSingleBlockTakesWhatIsAskedHoweverLittleOrMuchItNeeds(int need) {
        for (double effort : new double[] {1, 0x1p30, 0x1p64}) {
            SampleDemand needs = needs(need, need - 4, need);
            BlockAllocation allocation = allocation(effort, 1);
            allocation.limit(needs, BLOCK, RAYS);
            assertEquals(SAMPLES, taken(allocation.ofBlock(), needs), SAMPLES * 8 / 64 / 2);
        }
    }

    @Test
    void oneOfSeveralBlocksStaysBetweenTheRootOfTheirNumberAndItsInverse() {
        for (int seed = 1; seed < 100; seed++) {
            SampleDemand needs = needs(seed, -40, -40 + seed % 40);
            for (int blocks = 2; blocks < 64; blocks *= 2) {
                BlockAllocation allocation = allocation(Math.scalb(1.0, seed % 64), blocks);
                allocation.limit(needs, BLOCK, RAYS);
                double ratio = taken(allocation.ofBlock(), needs) / SAMPLES;
                // A step of one pixel that takes 64 times the mean, the most that one may, from half of that.
                double step = 32.0 / 64;
                assertTrue(ratio <= Math.sqrt(blocks) + step / 2, ratio + " times the mean of " + blocks);
                assertTrue(ratio >= 1 / Math.sqrt(blocks) - step / 2, ratio + " of the mean of " + blocks);
                assertEquals(SAMPLES * ratio, allocation.spent(needs, BLOCK, RAYS) / 64, SAMPLES * step / 2);
            }
        }
    }

    @Test
    void whatIsWithinTheLimitsIsLeftAsItIs() {
        SampleDemand needs = needs(7, -20, -10);
        Allocation plain = new Allocation(0x1p24, SAMPLES, 1);
        double wanted = taken(plain, needs);
        // Four blocks: half of the mean to twice as much.
        assertTrue(wanted > SAMPLES / 2 && wanted < 2 * SAMPLES, wanted + " samples");
        BlockAllocation allocation = allocation(0x1p24, 4);
        allocation.limit(needs, BLOCK, RAYS);
        assertEquals(wanted, taken(allocation.ofBlock(), needs));
        assertEquals(64 * wanted, allocation.spent(needs, BLOCK, RAYS), 1e-9);
    }

    /** A sixteenth of what the block takes at most, and four samples of each pixel at most; none for less than 16. */
    @Test
    void aBlockIsLookedAtApartWithASmallShareOfWhatItTakes() {
        for (double mean = 1; mean < 1000; mean *= 1.3) {
            int apart = new BlockAllocation(1, 1, 1, BlockLimits.ofFew(mean, 3)).apart();
            if (mean < 16) {
                assertEquals(-1, apart);
            } else {
                double looked = Math.scalb(1.0, apart);
                assertTrue(looked <= mean / 16 && looked > Math.min(mean / 32, 3.9), looked + " of " + mean);
            }
        }
        for (int apart = -1; apart <= 2; apart++) {
            double mean = BlockAllocation.samplesFor(apart);
            assertEquals(apart, new BlockAllocation(1, 1, 1, BlockLimits.ofFew(mean, 3)).apart());
        }
    }

    @Test
    void withoutLimitsTheEffortIsThatOfThePicture() {
        SampleDemand needs = needs(5, -30, 0);
        BlockAllocation allocation = new BlockAllocation(0x1p30, SAMPLES, 1, BlockLimits.NONE);
        allocation.limit(needs, BLOCK, RAYS);
        double plain = taken(new Allocation(0x1p30, SAMPLES, 1), needs);
        assertEquals(plain, taken(allocation.ofBlock(), needs));
        assertEquals(64 * plain, allocation.spent(needs, BLOCK, RAYS));
    }
}

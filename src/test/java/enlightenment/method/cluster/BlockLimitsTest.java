package enlightenment.method.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class BlockLimitsTest {
    @Test
    void aPictureOfOneBlockGetsJustWhatIsAsked() {
        BlockLimits limits = BlockLimits.of(16, 1);
        assertEquals(16, limits.limited(1));
        assertEquals(16, limits.limited(1e9));
    }

    /** If a block of P, of which none showed anything when they were tried, takes as much as it can, √P/P is added to the sum. */
    @Test
    void aBlockThatWasMissedAddsNoMoreThanTheRootOfTheirNumberTells() {
        for (int tried = 1; tried < 1000; tried *= 3) {
            double most = BlockLimits.of(16, tried).limited(Double.POSITIVE_INFINITY);
            assertEquals(16 / Math.sqrt(tried), most / tried, 1e-12);
        }
    }

    /** If one of few blocks takes as little or as much as it can, the others the mean, the sum changes by less than 1/√P. */
    @Test
    void ofFewBlocksNoneTakesLessThanTheInverseOfTheRootOfTheirNumber() {
        assertEquals(16, BlockLimits.ofFew(16, 1).limited(0));
        assertEquals(16, BlockLimits.ofFew(16, 1).limited(1e9));
        assertEquals(4, BlockLimits.ofFew(16, 16).limited(0), 1e-12);
        assertEquals(64, BlockLimits.ofFew(16, 16).limited(1e9), 1e-12);
    }

    @Test
    void theMoreWereTriedTheLessIsLimited() {
        for (int tried = 1; tried < 1000; tried++) {
            BlockLimits few = BlockLimits.of(16, tried);
            BlockLimits more = BlockLimits.of(16, tried + 1);
            assertTrue(more.limited(0) < few.limited(0));
            assertTrue(more.limited(1e9) > few.limited(1e9));
            assertEquals(16, more.limited(16));
        }
    }
}

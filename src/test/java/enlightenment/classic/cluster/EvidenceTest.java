package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** What the first samples of some pixels say about the others, and nothing about themselves. */
class EvidenceTest {
    private static final Block BLOCK = new Block(0, 0, 8, 8);

    /** SampleDemand of a block whose pixels are told these surprises; pixels of the first two columns have corners that differ. */
    private static double[] raised(Block block, double[] surprise, double before) {
        return raised(block, surprise, before, false);
    }

    private static double[] raised(Block block, double[] surprise, double before, boolean ofOwnToo) {
        Evidence evidence = new Evidence();
        SampleDemand needs = new SampleDemand();
        evidence.begin(ofOwnToo);
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                int k = FilmTile.BLOCK_SIDE * j + i;
                needs.edge[k] = before;
                evidence.tell(k, i >= 2, surprise[k]);
            }
        }
        evidence.raise(needs, block);
        return needs.edge;
    }

    @Test
    void aPixelLearnsNothingFromItsOwnSamples() {
        double[] surprise = new double[64];
        for (int k = 0; k < 64; k++) {
            surprise[k] = k * 37 % 11 / 8.0;
        }
        double[] one = raised(BLOCK, surprise, 0x1p-20);
        for (int own = 0; own < 64; own++) {
            double[] other = surprise.clone();
            other[own] += 4;
            double[] changed = raised(BLOCK, other, 0x1p-20);
            // Sums of multiples of 1/8: no rounding.
            assertEquals(one[own], changed[own], "pixel " + own);
            int neighbour = own % 8 == 7 || own % 8 == 1 ? own - 1 : own + 1;
            assertTrue(changed[neighbour] > one[neighbour], "pixel beside " + own);
        }
    }

    /** All 48 pixels whose corners met the same expect one pixel's surprise: 8 of it and of those that touch it count beside 1 of the others. */
    @Test
    void fromSamplesThatAreNoPartOfThePictureItLearnsToo() {
        double[] surprise = new double[64];
        int own = 8 * 4 + 4;
        surprise[own] = 1;
        double[] raised = raised(BLOCK, surprise, 0, true);
        double weight = 8 * 9 + (48 - 9);
        assertEquals(6 * 8 / weight, raised[own], 1e-15);
        assertEquals(6 * 8 / weight, raised[own - 9], 1e-15);
        assertEquals(6 / weight, raised[own - 18 + 1], 1e-15);
        assertEquals(0, raised(BLOCK, surprise, 0)[own]);
    }

    @Test
    void whereNothingSurprisesNothingChanges() {
        assertAll(raised(BLOCK, new double[64], 0.25), 0.25, 0.25);
        double[] less = new double[64];
        Arrays.fill(less, -1);
        assertAll(raised(BLOCK, less, 0.25), 0.25, 0.25);
    }

    @Test
    void theSameSurpriseEverywhereIsExpectedEverywhere() {
        double[] same = new double[64];
        Arrays.fill(same, 0.5);
        assertAll(raised(BLOCK, same, 0), 0.5, 6 * 0.5);
        // What the corners of an edge let expect is more.
        assertAll(raised(BLOCK, same, 2), 2, 2 + 6 * 0.5);
    }

    private static void assertAll(double[] needs, double ofEdge, double ofOthers) {
        for (int k = 0; k < 64; k++) {
            assertEquals(k % 8 < 2 ? ofEdge : ofOthers, needs[k], "pixel " + k);
        }
    }

    @Test
    void besideTheOutlineOfALargeThingNothingIsExpected() {
        double[] outline = new double[64];
        for (int k = 0; k < 64; k++) {
            outline[k] = k % 8 < 2 ? 0.25 : 0;
        }
        assertAll(raised(BLOCK, outline, 0), 0.25, 0);
    }

    @Test
    void nearPixelsTellMoreThanThoseFarAway() {
        double[] one = new double[64];
        one[8 * 4 + 5] = 1;
        double[] needs = raised(BLOCK, one, 0);
        assertEquals(needs[8 * 3 + 4], needs[8 * 5 + 6]);
        assertTrue(needs[8 * 4 + 4] > 4 * needs[7], "beside " + needs[8 * 4 + 4] + ", far away " + needs[7]);
        assertTrue(needs[7] > 0);
    }

    @Test
    void aSinglePixelHasNobodyToLearnFrom() {
        double[] surprise = new double[64];
        surprise[0] = 9;
        assertEquals(0.125, raised(new Block(0, 0, 1, 1), surprise, 0.125)[0]);
    }
}

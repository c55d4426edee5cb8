package enlightenment.classic.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Distribution;
import enlightenment.world.parts.RayCounters;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What the clusters of a block are worth together. */
class ClusterGuideTest {
    private final ClusterGuide guide = new ClusterGuide(Distribution.of("normal"), new RayCounters(1));
    private final Random random = new Random(7);

    /** Watches a light of which a small hole is seen, in one place. */
    private void watchHole(int light, int points) {
        for (int k = 0; k < points; k++) {
            watch(light, (p, q) -> (p - 0.3) * (p - 0.3) + q * q > 0.15 * 0.15);
        }
    }

    /** Watches a light that is hidden like the fields of a fine chessboard: nothing can be learned. */
    private void watchBoard(int light, int points) {
        for (int k = 0; k < points; k++) {
            watch(light, (p, q) -> (Math.floor(40 * p) + Math.floor(40 * q)) % 2 == 0);
        }
    }

    private interface Hidden {
        boolean at(double p, double q);
    }

    private void watch(int light, Hidden hidden) {
        guide.at(8 * random.nextDouble(), 8 * random.nextDouble());
        guide.begin(1, light, 0);
        double weight = guide.propose(random.nextDouble(), random.nextDouble());
        guide.tell(1, light, 0, guide.p(), guide.q(), weight, hidden.at(guide.p(), guide.q()));
    }

    @Test
    void oneLightThatIsWellProposedLeavesTheNoiseOfTheOthers() {
        guide.reset();
        watchHole(0, 3000);
        assertTrue(guide.fit());
        double alone = guide.gain();
        assertTrue(alone > 3, "alone " + alone);
        guide.reset();
        watchHole(0, 3000);
        watchBoard(1, 2900);
        watchBoard(2, 2900);
        assertTrue(guide.fit());
        // The hole is 0.0225 of its disk and varies by 0.022 per point, each board by 1/4.
        double hole = 0.0225 * 0.9775 * 3000;
        double boards = 0.25 * 5800;
        assertEquals((hole + boards) / (hole / alone + boards), guide.gain(), 0.02);
    }

    @Test
    void whatIsNotLearnedGainsNothing() {
        guide.reset();
        watchBoard(0, 500);
        guide.fit();
        assertEquals(1, guide.gain());
    }
}

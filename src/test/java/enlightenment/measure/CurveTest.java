package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class CurveTest {
    /** Error 0.08/√n in n/10 seconds, with three seeds of which one was disturbed: 1, 4, 16, 64 samples. */
    private static List<TradeRun> runs() {
        List<TradeRun> runs = new ArrayList<>();
        for (int n = 1; n <= 64; n *= 4) {
            for (int seed = 0; seed < 3; seed++) {
                double wall = n / 10.0 * (seed == 2 ? 5 : 1);
                runs.add(SyntheticRuns.run("cluster", n, seed, 0.0064 / n, wall));
            }
        }
        return runs;
    }

    private static final Curve CURVE = Curve.of("cluster", runs(), 0);

    @Test
    void mediansPassOverADisturbedRun() {
        assertEquals(new Spread(1.6, 1.6, 8, 3), CURVE.points().get(2).wall());
        assertEquals(4, CURVE.points().size());
    }

    @Test
    void theBudgetForAnErrorIsFoundBetweenThoseThatWereTried() {
        Curve.Estimate estimate = CURVE.samplesFor(0.016).orElseThrow();
        assertEquals(25, estimate.samples(), 1e-9);
        assertEquals(2.5, estimate.wall(), 1e-9);
        assertTrue(estimate.measured());
    }

    @Test
    void beyondTheLastBudgetTheLineGoesOnAndSaysSo() {
        Curve.Estimate estimate = CURVE.samplesFor(0.001).orElseThrow();
        assertEquals(6400, estimate.samples(), 1e-6);
        assertEquals(640, estimate.wall(), 1e-7);
        assertFalse(estimate.measured());
    }

    @Test
    void anErrorThatOneSampleUndercutsNeedsOneSample() {
        assertEquals(1, CURVE.samplesFor(0.5).orElseThrow().samples());
    }

    @Test
    void theBudgetForATimeIsFoundAmongUndisturbedRuns() {
        assertEquals(25, CURVE.samplesIn(2.5), 1e-9);
        assertEquals(1, CURVE.samplesIn(0.001), 1e-9);
        assertEquals(96, CURVE.samplesIn(9.6), 1e-9);
    }

    @Test
    void runsThatCannotBeToldFromTheReferenceDoNotBendTheLine() {
        // The last rung's squared error is 0.0001 by now, all of it the reference's.
        List<TradeRun> runs = runs().stream()
                .map(r -> SyntheticRuns.run(
                        "cluster", r.samples(), r.seed(), r.meanSquaredDifference() + 1e-3, r.wallSeconds()))
                .toList();
        Curve curve = Curve.of("cluster", runs, 1e-3);
        assertEquals(3, curve.judgedPoints().size());
        assertEquals(-0.5, curve.overSamples().orElseThrow().slope(), 1e-9);
    }

    @Test
    void itCountsHowOftenTheTruthLayInsideTheRendersOwnInterval() {
        assertEquals(12, CURVE.judged());
        assertEquals(12, CURVE.insideOwnInterval());
    }

    @Test
    void budgetsThatComeToTheSameNumberOfSamplesGiveNoLine() {
        List<TradeRun> runs =
                List.of(SyntheticRuns.run("cluster", 2, 1, 0.01, 1), SyntheticRuns.run("cluster", 2, 2, 0.011, 1.1));
        assertTrue(Curve.of("cluster", runs, 0).overSamples().isEmpty());
        assertTrue(Curve.of("cluster", runs, 0).overTime().isEmpty());
    }

    @Test
    void nothingIsKnownOfAMethodThatWasNotRun() {
        Curve none = Curve.of("raytrace", runs(), 0);
        assertTrue(none.samplesFor(0.01).isEmpty());
        assertTrue(none.overSamples().isEmpty());
        assertTrue(none.last().isEmpty());
    }
}

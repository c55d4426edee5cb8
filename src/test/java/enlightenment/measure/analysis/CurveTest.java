package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.TradeRun;
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

    private static final Configuration CLUSTER = new Configuration("cluster", 10, false);
    private static final Curve CURVE = Curve.of(CLUSTER, runs(), 0);

    @Test
    void mediansPassOverADisturbedRun() {
        assertEquals(new Spread(1.6, 1.6, 8, 3), CURVE.points().get(2).wall());
        assertEquals(4, CURVE.points().size());
    }

    @Test
    void runsThatCannotBeToldFromTheReferenceDoNotBendTheLine() {
        // The last two rungs' squared errors are 0.0004 and 0.0001, less than the reference's.
        List<TradeRun> runs = runs().stream()
                .map(r -> SyntheticRuns.run(
                        "cluster", r.samples(), r.seed(), r.meanSquaredDifference() + 1e-3, r.wallSeconds()))
                .toList();
        Curve curve = Curve.of(CLUSTER, runs, 1e-3);
        assertEquals(2, curve.judgedPoints().size());
        assertEquals(-0.5, curve.overSamples().orElseThrow().slope(), 1e-9);
    }

    @Test
    void otherNumbersOfLightPointsAreOtherCurves() {
        List<TradeRun> runs = new ArrayList<>(runs());
        runs.add(SyntheticRuns.of(TradeRun.BUDGET_SERIES, "cluster", 1, 256, 1, 1, 1, 1));
        assertEquals(CURVE, Curve.of(CLUSTER, runs, 0));
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
        assertTrue(Curve.of(CLUSTER, runs, 0).overSamples().isEmpty());
        assertTrue(Curve.of(CLUSTER, runs, 0).overTime().isEmpty());
    }

    @Test
    void nothingIsKnownOfAMethodThatWasNotRun() {
        Curve none = Curve.of(new Configuration("raytrace", 10, false), runs(), 0);
        assertTrue(none.points().isEmpty());
        assertTrue(none.overSamples().isEmpty());
    }
}

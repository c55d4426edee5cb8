package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.Spread;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class MeasuredCostsTest {
    private static final Configuration CLUSTER = new Configuration("cluster", 10, false);

    /** Error 0.08/√n and FLIP 0.2/√n in n/10 seconds: 1, 2, ..., 64 samples, down to an error of 0.01. */
    private static final List<TradeRun> SERIES = SyntheticRuns.series("cluster", 10, 64, 0.08, 0.2, 0.1);

    private static MeasuredCosts costs(List<TradeRun> runs, double referenceError) {
        return MeasuredCosts.of(CLUSTER, runs, 2, referenceError * referenceError);
    }

    @Test
    void betweenTwoMeasuredErrorsTheBudgetIsInterpolatedAndNamesBoth() {
        CostEstimate need = costs(SERIES, 0).forError(0.016).orElseThrow();
        assertEquals(25, need.samples(), 1e-9);
        assertEquals(2.5, need.wall().median(), 1e-9);
        assertEquals(5, need.cpu().orElseThrow().median(), 1e-9);
        assertEquals(0.04, need.flip().orElseThrow(), 1e-9);
        assertEquals(CostEstimate.Source.BETWEEN, need.source());
        assertEquals(0.02, need.from().get(0), 1e-12);
        assertEquals(0.08 / Math.sqrt(32), need.from().get(1), 1e-12);
        assertEquals("interpolated between measured errors of 0.020 and 0.014", need.evidence());
    }

    @Test
    void aMeasuredErrorNeedsNoInterpolation() {
        CostEstimate need = costs(SERIES, 0).forError(0.02).orElseThrow();
        assertEquals(CostEstimate.Source.MEASURED, need.source());
        assertEquals(16, need.samples());
        assertEquals("measured", need.evidence());
    }

    @Test
    void beyondTheLastBudgetTheLineGoesOnForOneDoublingAndSaysSo() {
        CostEstimate need = costs(SERIES, 0).forError(0.008).orElseThrow();
        assertEquals(100, need.samples(), 1e-9);
        assertEquals(10, need.wall().median(), 1e-9);
        assertFalse(need.isMeasured());
        assertEquals("extrapolated from 0.010, the smallest error measured", need.evidence());
        assertTrue(costs(SERIES, 0).forError(0.0049).isEmpty());
    }

    @Test
    void anErrorThatOneSampleUndercutsNeedsOneSampleAndSaysWhatItGives() {
        CostEstimate need = costs(SERIES, 0).forError(0.5).orElseThrow();
        assertEquals(1, need.samples());
        assertTrue(need.undercutsTarget());
        assertEquals("measured, gives 0.080 or less", need.evidence());
    }

    /** Where the method begins to work in another way, nothing in between was measured: it takes the better budget. */
    @Test
    void aJumpIsNotInterpolated() {
        List<TradeRun> runs =
                List.of(SyntheticRuns.run("cluster", 2, 1, 1e-4, 0.1), SyntheticRuns.run("cluster", 2.5, 1, 1e-8, 0.3));
        CostEstimate need = costs(runs, 0).forError(0.005).orElseThrow();
        assertEquals(CostEstimate.Source.MEASURED, need.source());
        assertEquals(2.5, need.samples());
        assertEquals(0.3, need.wall().median());
        assertTrue(need.undercutsTarget());
    }

    @Test
    void errorsBelowTheReferencesAreNotTold() {
        // The runs' differences hold the reference's error: 0.02, more than the last two errors, as much as the one
        // before.
        List<TradeRun> runs = SERIES.stream()
                .map(r -> SyntheticRuns.run(
                        "cluster", r.samples(), 1, r.meanSquaredDifference() + 0.0004, r.wallSeconds()))
                .toList();
        MeasuredCosts reach = costs(runs, 0.02);
        assertEquals(0.02, reach.mostAccurate().orElseThrow().error().median(), 1e-6);
        // The budgets beyond are known to give no more than the reference's error: no more than that is said of them.
        CostEstimate need = reach.forError(0.021).orElseThrow();
        assertTrue(need.isMeasured() && need.error() >= 0.02, need.toString());
        assertTrue(reach.measured(0.019).isEmpty());
    }

    @Test
    void whatWasTriedGoesFirstAndAnErrorAsCloseAsAskedBeforeASmallerOne() {
        List<TradeRun> runs = new ArrayList<>(SERIES);
        runs.add(SyntheticRuns.of(TradeRun.CHECK, "cluster", 10, 20, 0, 0.004 * 0.004, 3, 0.1));
        runs.add(SyntheticRuns.of(TradeRun.CHECK, "cluster", 10, 30, 0, 0.0155 * 0.0155, 2.7, 0.1));
        runs.add(SyntheticRuns.of(TradeRun.CHECK, "cluster", 10, 30, 0, 0.0155 * 0.0155, 2.9, 0.1));
        CostEstimate need = costs(runs, 0).forError(0.016).orElseThrow();
        assertEquals(CostEstimate.Source.TRIED, need.source());
        assertEquals(30, need.samples());
        assertEquals(new Spread(2.7, 2.8, 2.9, 2), need.wall());
    }

    @Test
    void timesOnOtherThreadsAreNotCompared() {
        assertTrue(MeasuredCosts.of(CLUSTER, SERIES, 1, 0).forError(0.02).isEmpty());
    }

    @Test
    void aGridOfPositionsIsAnotherContenderAndIsNotInterpolated() {
        TradeRun sweep = SyntheticRuns.of("sweep shadowSamples", "raytrace", 1, 0, 1, 0.0001, 3, 0.05);
        Configuration grid = new Configuration("raytrace", 1, true);
        assertEquals(grid, Configuration.of(sweep));
        CostEstimate need =
                MeasuredCosts.of(grid, List.of(sweep), 2, 0).forError(0.02).orElseThrow();
        assertEquals("--method raytrace --shadow-samples 1 --antialias 4", grid.options(need.samples(), 10));
        assertEquals(3, need.wall().median());
        assertTrue(need.undercutsTarget());
    }

    @Test
    void theBudgetForATimeIsFoundAmongThoseMeasuredAndALittleBeyond() {
        assertEquals(25, costs(SERIES, 0).samplesIn(2.5), 1e-9);
        assertEquals(1, costs(SERIES, 0).samplesIn(0.001), 1e-9);
        assertEquals(96, costs(SERIES, 0).samplesIn(9.6), 1e-9);
    }

    @Test
    void flipHasItsOwnCrossing() {
        // FLIP 0.2/√n = 0.04 at 25 samples.
        CostEstimate need = costs(SERIES, 0).forFlip(0.04).orElseThrow();
        assertEquals(2.5, need.wall().median(), 1e-9);
        assertEquals(0.016, need.error(), 1e-9);
        assertTrue(costs(SERIES, 0).forFlip(0.01).isEmpty());
    }
}

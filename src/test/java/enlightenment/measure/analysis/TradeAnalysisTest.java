package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class TradeAnalysisTest {
    private static TradeAnalysis on(int processors, List<TradeRun> runs) {
        TradeResult result = SyntheticRuns.trade(0, runs).result();
        return TradeAnalysis.of(new TradeResult(
                result.settings(),
                result.reference(),
                runs,
                new TradeResult.Conditions(
                        Map.of(TradeResult.Conditions.PROCESSORS, Integer.toString(processors)), 0, 1, true),
                Map.of()));
    }

    /** Synthetic runs use two threads. */
    @Test
    void theShareOfTheProcessorsIsProcessorTimeByWhatTheThreadsCouldGet() {
        TradeRun run = SyntheticRuns.run("raytrace", 4, 1, 0.01, 1);
        assertEquals(0.75, on(8, List.of(run.withTimes(2, 3))).shareOfProcessors());
        // Two threads on one processor can get no more than that one.
        assertEquals(0.5, on(1, List.of(run.withTimes(2, 1))).shareOfProcessors());
        assertEquals(1, on(8, List.of(run.withTimes(2, 0))).shareOfProcessors());
    }

    @Test
    void shortRendersDoNotTellHowBusyTheMachineWas() {
        List<TradeRun> runs = new ArrayList<>();
        for (int i = 0; i < 7; i++) {
            runs.add(SyntheticRuns.run("raytrace", 64, i, 0.01, 1).withTimes(1, 1.8));
        }
        for (int i = 0; i < 20; i++) {
            runs.add(SyntheticRuns.run("raytrace", 1, i, 0.01, 1).withTimes(0.01, 0.001));
        }
        assertEquals(0.9, on(2, runs).shareOfProcessors());
    }

    /** raytrace ends at 0.01 and would extrapolate to 0.008 in a moment; cluster was measured there, slowly. */
    @Test
    void whatWasMeasuredIsPreferredToWhatIsExtrapolatedAndFaster() {
        List<TradeRun> runs = new ArrayList<>(SyntheticRuns.series("raytrace", 10, 64, 0.08, 0.1, 0.001));
        runs.addAll(SyntheticRuns.series("cluster", 10, 1024, 0.08, 0.1, 1));
        TradeAnalysis analysis = SyntheticRuns.trade(0, runs);
        assertFalse(analysis.own("raytrace", 0.008).orElseThrow().isMeasured());
        CostEstimate fastest = TradeAnalysis.fastest(analysis.costs(), 0.008).orElseThrow();
        assertEquals("cluster", fastest.method());
        assertTrue(fastest.isMeasured());
    }

    @Test
    void errorsBelowTheReferencesAreNotKnown() {
        TradeAnalysis analysis = SyntheticRuns.trade(0.005, List.of());
        assertTrue(analysis.isKnown(0.005));
        assertFalse(analysis.isKnown(0.0049));
    }
}

package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.Advice;
import enlightenment.measure.trade.Advice.Basis;
import enlightenment.measure.trade.TradeRun;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Two methods whose curves, and so whose crossing and ratios, are known. */
class VerdictTest {
    private static TradeAnalysis trade(double referenceError, List<List<TradeRun>> parts) {
        List<TradeRun> runs = new ArrayList<>();
        parts.forEach(runs::addAll);
        return SyntheticRuns.trade(referenceError, runs);
    }

    private static List<TradeRun> raytrace(int lightSamples, int most, double error, double seconds) {
        return SyntheticRuns.series("raytrace", lightSamples, most, error, error, seconds);
    }

    /** Error E takes seconds·(error/E)²: with errors 0.08 and 0.04 for the same time, cluster is four times faster. */
    private static List<TradeRun> cluster(int most, double error, double seconds) {
        return SyntheticRuns.series("cluster", 10, most, error, error, seconds);
    }

    @Test
    void theRatioIsThatOfTheTimesToTheSameError() {
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 1024, 0.08, 0.1), cluster(1024, 0.04, 0.1)));
        Verdict verdict = Verdict.of(trade, 0.005);
        assertEquals(Basis.MEASURED, verdict.known());
        assertEquals("cluster", verdict.best().orElseThrow().method());
        assertEquals(4, verdict.comparisons().get(0).ratio(), 1e-9);
        assertEquals(
                "For an error of 0.005 use --method cluster --samples 64 --depth 16: 6.4 s (measured), 4.0 times faster "
                        + "than raytrace with 10 light samples (measured).",
                verdict.sentence());
    }

    /** In parallel lines there is no crossing; here one method has 0.05 s to begin with and falls more steeply. */
    @Test
    void onEitherSideOfTheCrossingTheOtherMethodIsBest() {
        List<TradeRun> steep = new ArrayList<>();
        for (int n = 1; n <= 64; n *= 2) {
            steep.add(SyntheticRuns.run("cluster", n, 1, Math.pow(0.06 / n, 2), 0.4 * n));
        }
        // cluster: E takes 0.4·0.06/E; raytrace: 0.1·(0.08/E)²; they meet at E = 0.00064/0.024 = 0.0267.
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 4096, 0.08, 0.1), steep));
        assertEquals("raytrace", Verdict.of(trade, 0.03).best().orElseThrow().method());
        assertEquals("cluster", Verdict.of(trade, 0.024).best().orElseThrow().method());
        assertTrue(Verdict.of(trade, 0.0267).comparisons().get(0).alike());
        double ratio = Verdict.of(trade, 0.01).comparisons().get(0).ratio();
        assertEquals(6.4 / 2.4, ratio, 0.01);
    }

    @Test
    void interpolatedTimesNameTheMeasuredErrors() {
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 1024, 0.08, 0.1), cluster(1024, 0.04, 0.1)));
        String sentence = Verdict.of(trade, 0.004).sentence();
        assertTrue(
                sentence.contains("10 s (interpolated between measured errors of 0.0050 and 0.0035), 4.0 times faster"),
                sentence);
    }

    @Test
    void belowTheReferencesOwnErrorThereIsNoVerdictWhateverWasTried() {
        TradeAnalysis trade = trade(0.0015, List.of(raytrace(10, 16384, 0.08, 0.1), cluster(16384, 0.04, 0.1)));
        Verdict verdict = Verdict.of(trade, 0.001);
        assertEquals(Basis.NOTHING, verdict.known());
        assertTrue(verdict.best().isEmpty() && verdict.comparisons().isEmpty());
        assertTrue(verdict.sentence().contains("no verdict: the reference's own error is 0.0015"), verdict.sentence());
        assertFalse(verdict.sentence().contains("times"), verdict.sentence());
    }

    /** The defect: 0.0156 and 0.0087 were measured, and the sentence said 21 times faster at 0.001. */
    @Test
    void beyondWhatWasMeasuredThereIsNoRatioAndTheSentenceSaysThatItIsExtrapolated() {
        // raytrace: 0.01 with 64 samples is the smallest; cluster as well with 16.
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 64, 0.08, 0.1), cluster(16, 0.04, 0.1)));
        Verdict near = Verdict.of(trade, 0.008);
        assertEquals(Basis.EXTRAPOLATED, near.known());
        assertTrue(near.sentence().contains("nothing was measured; extrapolated"), near.sentence());
        Verdict far = Verdict.of(trade, 0.001);
        assertEquals(Basis.NOTHING, far.known());
        assertTrue(
                far.sentence()
                        .contains(
                                "the smallest errors measured are 0.010 by raytrace with 10 light samples and 0.010 by "
                                        + "cluster"),
                far.sentence());
        for (Verdict v : List.of(near, far)) {
            assertTrue(v.comparisons().isEmpty());
            assertFalse(v.sentence().contains("times faster"), v.sentence());
        }
    }

    @Test
    void aMethodThatDidNotGetThereIsNotCompared() {
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 64, 0.08, 0.1), cluster(1024, 0.04, 0.1)));
        Verdict verdict = Verdict.of(trade, 0.005);
        assertEquals(Basis.MEASURED, verdict.known());
        assertTrue(verdict.comparisons().isEmpty());
        assertTrue(
                verdict.sentence()
                        .endsWith(
                                "which raytrace with 10 light samples was not measured to reach (its smallest error is "
                                        + "0.010, in 6.4 s)."),
                verdict.sentence());
    }

    /** With 1 light sample: 0.1 for one sample in a tenth of the time; 0.005 takes 400 · 0.01 = 4 s instead of 25.6. */
    @Test
    void raytraceIsComparedAtItsBestNumberOfLightPointsAsWell() {
        TradeAnalysis trade = trade(
                0, List.of(raytrace(10, 1024, 0.08, 0.1), raytrace(1, 1024, 0.1, 0.01), cluster(1024, 0.04, 0.03)));
        Verdict verdict = Verdict.of(trade, 0.005);
        // cluster: 64 · 0.03 = 1.92 s.
        assertEquals(
                List.of("raytrace with 10 light samples", "raytrace with 1 light sample"),
                verdict.comparisons().stream()
                        .map(c -> c.cost().configuration().name())
                        .toList());
        assertEquals(25.6 / 1.92, verdict.comparisons().get(0).ratio(), 1e-9);
        assertEquals(4 / 1.92, verdict.comparisons().get(1).ratio(), 1e-9);
        assertTrue(
                verdict.sentence().contains("2.1 times faster than raytrace with 1 light sample, its best of 1, 10 ("),
                verdict.sentence());
    }

    @Test
    void theBestNumberOfLightPointsMayBeTheAdvice() {
        TradeAnalysis trade = trade(
                0, List.of(raytrace(10, 1024, 0.08, 0.1), raytrace(1, 1024, 0.08, 0.01), cluster(1024, 0.04, 0.1)));
        Verdict verdict = Verdict.of(trade, 0.005);
        assertTrue(
                verdict.sentence()
                        .startsWith("For an error of 0.005 use --method raytrace --shadow-samples 1 --samples 256 "),
                verdict.sentence());
        assertEquals(10, verdict.comparisons().get(0).ratio(), 1e-9);
        assertEquals(2.5, verdict.comparisons().get(1).ratio(), 1e-9);
    }

    /** Equal RMSE in half the time, but FLIP four times as large: by FLIP raytrace needs a 16th of the samples. */
    @Test
    void whereFlipDisagreesTheSentenceSaysSo() {
        List<TradeRun> cluster = SyntheticRuns.series("cluster", 10, 1024, 0.08, 0.32, 0.05);
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 1024, 0.08, 0.1), cluster));
        Verdict verdict = Verdict.of(trade, 0.005);
        assertEquals("cluster", verdict.best().orElseThrow().method());
        assertTrue(
                verdict.sentence()
                        .endsWith("; by FLIP it is the other way round: for a FLIP of at most 0.020 raytrace with 10 "
                                + "light samples took 1.6 s (measured)."),
                verdict.sentence());
        TradeAnalysis agree = trade(0, List.of(raytrace(10, 1024, 0.08, 0.1), cluster(1024, 0.08, 0.05)));
        assertFalse(Verdict.of(agree, 0.005).sentence().contains("FLIP"));
    }

    /** One budget only, and it gives half of the error: that says at most how long the error would take. */
    @Test
    void aTimeForASmallerErrorIsABound() {
        List<TradeRun> sweep =
                List.of(SyntheticRuns.of("sweep shadowSamples", "raytrace", 1, 0, 1, 0.0025 * 0.0025, 8, 0.1));
        TradeAnalysis trade = trade(0, List.of(sweep, cluster(1024, 0.04, 0.05)));
        String sentence = Verdict.of(trade, 0.005).sentence();
        assertTrue(
                sentence.contains("at most 2.5 times faster than raytrace --antialias with 1 light sample"), sentence);
        assertTrue(sentence.contains("(measured, gives 0.0025 or less)"), sentence);
        // At the error that it does give the ratio is known: 8 s against 0.05 · (0.04 / 0.0025)² = 12.8 s.
        EqualErrorComparison there = EqualErrorComparison.all(trade).stream()
                .filter(m -> m.error() == 0.0025)
                .findFirst()
                .orElseThrow();
        assertEquals(12.8 / 8, there.timesAsLong(there.costs().get(1)), 1e-9);
    }

    @Test
    void meetingsAreWhereBothWereMeasuredAndNowhereElse() {
        TradeAnalysis trade =
                trade(0, List.of(raytrace(10, 64, 0.08, 0.1), raytrace(1, 256, 0.08, 0.05), cluster(1024, 0.04, 0.1)));
        List<EqualErrorComparison> all = EqualErrorComparison.all(trade);
        EqualErrorComparison scene =
                all.stream().filter(m -> m.smallest() && !m.best()).findFirst().orElseThrow();
        assertEquals(0.01, scene.error(), 1e-12);
        assertEquals(4, scene.timesAsLong(scene.costs().get(0)), 1e-9);
        EqualErrorComparison best =
                all.stream().filter(m -> m.smallest() && m.best()).findFirst().orElseThrow();
        assertEquals(0.005, best.error(), 1e-12);
        assertEquals(2, best.timesAsLong(best.costs().get(0)), 1e-9);
        assertTrue(all.stream()
                .allMatch(m -> m.error() >= 0.005 && m.costs().get(0).isMeasured()));
    }

    /** raytrace was measured down to 0.01, light to 0.005, cluster to 0.00125: two of them meet at 0.005, all three at 0.01. */
    @Test
    void ofThreeMethodsThoseMeetThatWereMeasuredThere() {
        List<TradeRun> runs = new ArrayList<>(raytrace(10, 64, 0.08, 0.1));
        runs.addAll(SyntheticRuns.series("light", 10, 64, 0.04, 0.04, 0.2));
        runs.addAll(cluster(1024, 0.04, 0.1));
        List<String> methods = List.of("raytrace", "light", "cluster");
        List<EqualErrorComparison> all = EqualErrorComparison.all(SyntheticRuns.trade(methods, Map.of(), runs));
        List<String> smallest = all.stream()
                .filter(m -> m.smallest() && !m.best())
                .map(m -> Digits.of(m.error(), 2) + " "
                        + m.costs().stream().map(CostEstimate::method).toList())
                .toList();
        assertEquals(List.of("0.010 [raytrace, light, cluster]", "0.0050 [light, cluster]"), smallest);
        EqualErrorComparison three = all.get(0);
        assertEquals("cluster", three.fastest().method());
        assertEquals(4, three.timesAsLong(three.costs().get(0)), 1e-9);
        assertEquals(2, three.timesAsLong(three.costs().get(1)), 1e-9);
        // Whoever cannot see all of the scene meets nobody, and nobody advises it.
        TradeAnalysis blind = SyntheticRuns.trade(methods, Map.of("cluster", "cluster sees nothing"), runs);
        assertTrue(EqualErrorComparison.all(blind).stream()
                .flatMap(m -> m.costs().stream())
                .noneMatch(n -> n.method().equals("cluster")));
        Verdict verdict = Verdict.of(blind, 0.01);
        assertEquals("light", verdict.best().orElseThrow().method());
        assertFalse(verdict.sentence().contains("cluster"), verdict.sentence());
    }

    /** How far below the reference's error something is cannot be told, so its time is a bound, also just above that error. */
    @Test
    void aTimeForAnErrorBelowTheReferencesIsABound() {
        // cluster jumps from 0.02 to an error that is lost in the reference's 0.0045: 0.3 s.
        List<TradeRun> jump = new ArrayList<>();
        jump.add(SyntheticRuns.run("cluster", 2, 1, 0.0004 + 0.0045 * 0.0045, 0.1));
        jump.add(SyntheticRuns.run("cluster", 2.5, 1, 1e-8 + 0.0045 * 0.0045, 0.3));
        List<TradeRun> known = raytrace(10, 256, 0.08, 0.01).stream()
                .map(r -> SyntheticRuns.run(
                        "raytrace", r.samples(), 1, r.meanSquaredDifference() + 0.0045 * 0.0045, r.wallSeconds()))
                .toList();
        TradeAnalysis trade = trade(0.0045, List.of(known, jump));
        String sentence = Verdict.of(trade, 0.005).sentence();
        assertTrue(
                sentence.contains(
                        "0.30 s (measured, gives less than the reference's own error of 0.0045), at least 8.5 times"),
                sentence);
        EqualErrorComparison smallest = EqualErrorComparison.all(trade).stream()
                .filter(EqualErrorComparison::smallest)
                .findFirst()
                .orElseThrow();
        assertEquals(0.005, smallest.error(), 1e-6);
        assertTrue(smallest.costs().get(1).undercutsTarget());
    }

    @Test
    void nothingMeasuredIsNothingSaid() {
        Verdict verdict = Verdict.of(trade(0, List.of()), 0.01);
        assertEquals(Basis.NOTHING, verdict.known());
        assertTrue(EqualErrorComparison.all(trade(0, List.of())).isEmpty());
    }

    private static TradeRun timed(String method, double samples, long seed, double error, double seconds) {
        return SyntheticRuns.run(method, samples, seed, error * error, seconds);
    }

    @Test
    void timesWithinATenthOrThatOverlapAreCalledAlike() {
        TradeRun fast = timed("cluster", 16, 1, 0.01, 1);
        Verdict near = Verdict.of(trade(0, List.of(List.of(fast, timed("raytrace", 16, 1, 0.01, 1.09)))), 0.01);
        assertTrue(near.comparisons().get(0).alike());
        assertTrue(near.sentence().contains("about as fast as raytrace"), near.sentence());
        Verdict far = Verdict.of(trade(0, List.of(List.of(fast, timed("raytrace", 16, 1, 0.01, 1.11)))), 0.01);
        assertFalse(far.comparisons().get(0).alike());
        // Medians 1.2 and 2 s, but cluster once took longer than raytrace ever did at its best.
        List<TradeRun> scattered = List.of(
                fast,
                timed("cluster", 16, 2, 0.01, 1.2),
                timed("cluster", 16, 3, 0.01, 4),
                timed("raytrace", 16, 1, 0.01, 2));
        Verdict overlap = Verdict.of(trade(0, List.of(scattered)), 0.01);
        assertEquals(2 / 1.2, overlap.comparisons().get(0).ratio(), 1e-12);
        assertTrue(overlap.comparisons().get(0).alike());
    }

    /** 0.01 takes one sample by either method; 0.005 takes raytrace (0.008/0.005)² = 2.56. */
    @Test
    void theHeadlineIsForTheLargestErrorThatNeedsMoreThanOneSample() {
        TradeAnalysis trade = trade(0, List.of(raytrace(10, 1024, 0.008, 0.1), cluster(1024, 0.004, 0.1)));
        assertEquals(1, Verdict.of(trade, 0.01).best().orElseThrow().samples());
        assertEquals(0.005, Verdict.headline(trade).target());
        assertEquals(
                List.of(0.01, 0.005, 0.001),
                Verdict.all(trade).stream().map(Verdict::target).toList());
        // Nothing is measured at any of them: the first is as good as any.
        assertEquals(0.01, Verdict.headline(trade(0, List.of())).target());
    }

    /** Eight bits add 1/255/√12 = 0.0011: to 0.006 that is 2 %, to 0.005 already more. */
    @Test
    void smallErrorsAreKeptInSixteenBits() {
        TradeAnalysis trade = trade(0, List.of(cluster(1024, 0.04, 0.1)));
        assertEquals("--method cluster --samples 16", arguments(trade, 0.01));
        assertEquals("--method cluster --samples 64 --depth 16", arguments(trade, 0.005));
    }

    private static String arguments(TradeAnalysis trade, double target) {
        return Verdict.arguments(Verdict.of(trade, target).best().orElseThrow(), trade.settings());
    }

    @Test
    void theAdviceHasTheSettingsThatTheSentenceNames() {
        TradeAnalysis trade = trade(0, List.of(raytrace(1, 1024, 0.08, 0.01)));
        Verdict verdict = Verdict.of(trade, 0.005);
        assertTrue(
                verdict.sentence().contains("--method raytrace --shadow-samples 1 --samples 256"), verdict.sentence());
        Advice advice = verdict.advice(trade.settings());
        RenderSettings settings = advice.settings().orElseThrow();
        assertEquals(Method.RAYTRACE, settings.method());
        assertEquals(1, BuiltInMethod.RayTraceSettings.of(settings).shadowSamples());
        assertEquals(256, settings.budget().samples().orElseThrow());
        assertEquals(trade.settings().base().seed(), settings.seed());
        assertEquals(2.56, advice.seconds().orElseThrow().median(), 1e-12);
        assertEquals(Basis.MEASURED, advice.basis());
        Advice nothing = Verdict.of(trade, 1e-6).advice(trade.settings());
        assertEquals(Basis.NOTHING, nothing.basis());
        assertTrue(nothing.settings().isEmpty() && nothing.seconds().isEmpty());
    }
}

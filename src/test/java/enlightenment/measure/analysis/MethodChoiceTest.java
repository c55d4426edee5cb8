package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Methods whose curves are known: an error E takes seconds · (error/E)². */
class MethodChoiceTest {
    private static List<TradeRun> series(String method, int most, double error, double seconds) {
        return SyntheticRuns.series(method, 10, most, error, error, seconds);
    }

    private static MethodChoice choice(Map<String, String> blindSpots, List<List<TradeRun>> series) {
        List<TradeRun> runs = new ArrayList<>();
        List<String> methods = new ArrayList<>();
        for (List<TradeRun> one : series) {
            runs.addAll(one);
            methods.add(one.get(0).method());
        }
        return MethodChoice.of(SyntheticRuns.trade(methods, blindSpots, runs));
    }

    private static String sentence(List<List<TradeRun>> series) {
        return choice(Map.of(), series).sentence().orElseThrow();
    }

    @Test
    void oneMethodThatIsFasterAtAllErrorsIsTheChoice() {
        MethodChoice choice = choice(
                Map.of(),
                List.of(
                        series("raytrace", 4096, 0.32, 0.1),
                        series("light", 4096, 0.16, 0.1),
                        series("cluster", 4096, 0.08, 0.1)));
        assertEquals(
                "For this scene use cluster: 4.0 times faster than light and 16 times faster than raytrace at an error of "
                        + "0.005, and no other was measured to reach an error of 0.002.",
                choice.sentence().orElseThrow());
        assertEquals(1, choice.ranges().size());
        assertEquals(List.of("cluster"), choice.ranges().get(0).methods());
    }

    /** Cluster has 4 s to begin with and falls more steeply: 0.4·0.06/E against 0.1·(0.08/E)² meet at E = 0.027. */
    @Test
    void whereCurvesCrossEachMethodIsTheChoiceOnItsSide() {
        List<TradeRun> steep = new ArrayList<>();
        for (int n = 1; n <= 64; n *= 2) {
            steep.add(SyntheticRuns.run("cluster", n, 1, Math.pow(0.06 / n, 2), 0.4 * n));
        }
        String sentence = sentence(List.of(series("raytrace", 4096, 0.08, 0.1), steep));
        assertTrue(sentence.startsWith("For this scene use raytrace for errors of 0.05 and more: "), sentence);
        assertTrue(sentence.contains("; cluster for errors of 0.02 and less: "), sentence);
        // 0.1·(0.08/0.002)² = 160 s against 0.4·0.06/0.002 = 12 s; below, only one was measured.
        assertTrue(
                sentence.endsWith(
                        " 13 times faster than raytrace at an error of 0.002, and no other was measured to reach an error of 0.001."),
                sentence);
    }

    @Test
    void timesThatAreAlikeLeaveTheChoiceOpen() {
        String sentence = sentence(List.of(series("raytrace", 1024, 0.08, 0.1), series("cluster", 1024, 0.08, 0.105)));
        assertEquals(
                "For this scene use raytrace or cluster, which take about as long (measured down to an error of 0.005).",
                sentence);
    }

    @Test
    void aMethodThatAloneGotThereIsTheChoice() {
        String sentence = sentence(List.of(series("raytrace", 4, 0.8, 1), series("cluster", 64, 0.8, 1)));
        assertEquals("For this scene use cluster: no other was measured to reach an error of 0.2.", sentence);
    }

    @Test
    void whatCannotSeeAllIsLeftOutAndNamed() {
        MethodChoice choice = choice(
                Map.of("light", "light cannot see mirrors"),
                List.of(
                        series("raytrace", 4096, 0.32, 0.1),
                        series("light", 4096, 0.01, 0.1),
                        series("cluster", 4096, 0.16, 0.1)));
        assertEquals(List.of("light cannot see mirrors"), choice.leftOut());
        assertEquals(
                "For this scene use cluster: 4.0 times faster than raytrace at an error of 0.005.",
                choice.sentence().orElseThrow());
        MethodChoice single = choice(
                Map.of("light", "light cannot see mirrors"),
                List.of(series("raytrace", 64, 0.32, 0.1), series("light", 64, 0.01, 0.1)));
        assertTrue(single.sentence().isEmpty() && single.ranges().isEmpty());
    }

    @Test
    void withoutMeasurementsThereIsNoChoice() {
        MethodChoice none = MethodChoice.of(SyntheticRuns.trade(0, List.of()));
        assertTrue(none.ranges().isEmpty());
        assertTrue(none.sentence().orElseThrow().contains("is not known"), none.toString());
    }

    /** At 0.05 both take as long, below cluster is not measured: it is no rival that would be slower. */
    @Test
    void whatIsAlikeWhereItWasMeasuredIsNotCalledSlower() {
        List<TradeRun> short_ = List.of(
                SyntheticRuns.run("cluster", 1, 1, 0.1 * 0.1, 0.095),
                SyntheticRuns.run("cluster", 4, 1, 0.05 * 0.05, 0.39));
        MethodChoice choice = choice(Map.of(), List.of(series("raytrace", 64, 0.1, 0.1), short_));
        assertEquals(
                "For this scene use raytrace: no other was measured to reach an error of 0.02.",
                choice.sentence().orElseThrow());
    }

    /** None of them reached 0.2: all three were measured at 0.4, two of them down to 0.2125. */
    @Test
    void ofAHardSceneTheErrorsThatWereReachedAreCompared() {
        List<List<TradeRun>> all =
                List.of(series("raytrace", 4, 0.8, 1), series("light", 16, 0.85, 1), series("cluster", 4, 0.425, 1));
        assertEquals("For this scene use cluster: 4.0 times faster than light at an error of 0.22.", sentence(all));
    }
}

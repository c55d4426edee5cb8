package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.analysis.SyntheticRuns;
import enlightenment.measure.trade.TradeRun;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class VariantsTest {
    private static final Configuration OWN = new Configuration("raytrace", 10, false);

    private static List<Integer> worth(List<TradeRun> series) {
        return Variants.worthwhile(OWN, series).stream()
                .map(Configuration::lightSamples)
                .toList();
    }

    @Test
    void fewerAndMoreLightPointsAreTriedAtLeastAFactorOfTwoApart() {
        assertEquals(List.of(1, 4, 40), worth(List.of()));
        assertEquals(List.of(), Variants.worthwhile(new Configuration("cluster", 10, false), List.of()));
        assertEquals(
                List.of(4),
                Variants.worthwhile(new Configuration("raytrace", 1, false), List.of()).stream()
                        .map(Configuration::lightSamples)
                        .toList());
    }

    @Test
    void aVariantThatIsTwiceDominatedIsDropped() {
        List<TradeRun> runs = new ArrayList<>(SyntheticRuns.series("raytrace", 10, 16, 0.08, 0.1, 0.1));
        runs.addAll(SyntheticRuns.series("raytrace", 1, 2, 0.09, 0.1, 0.02));
        // Four times the time for nearly the same error: dominated. Fast but coarse: not.
        runs.addAll(SyntheticRuns.series("raytrace", 40, 1, 0.079, 0.1, 0.4));
        assertEquals(List.of(1, 4, 40), worth(runs));
        runs.addAll(SyntheticRuns.series("raytrace", 40, 2, 0.079, 0.1, 0.4));
        assertEquals(List.of(1, 4), worth(runs));
    }

    @Test
    void whatMakesTheSamePictureIsNotTriedAgain() {
        // A scene of point lights: the light samples change nothing.
        List<TradeRun> runs = new ArrayList<>(SyntheticRuns.series("raytrace", 10, 1, 0.08, 0.1, 0.1));
        runs.addAll(SyntheticRuns.series("raytrace", 4, 1, 0.08, 0.1, 0.1));
        assertEquals(List.of(1, 40), worth(runs));
    }
}

package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.TradeRun;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

class EqualTimeComparisonTest {
    private static EqualTimePicture picture(String method, double error, double flip, double seconds) {
        TradeRun run = SyntheticRuns.of(TradeRun.EQUAL_TIME, method, 10, 4, 0, error * error, seconds, flip);
        return new EqualTimePicture(run, Optional.empty(), Optional.empty(), 1);
    }

    private static String sentence(EqualTimePicture a, EqualTimePicture b) {
        return new EqualTimeComparison(List.of(a, b), 0, Set.of()).sentence().orElseThrow();
    }

    @Test
    void timesMoreThanATenthApartAreNotCalledEqual() {
        List<EqualTimePicture> pictures =
                List.of(picture("raytrace", 0.02, 0.02, 0.111), picture("cluster", 0.01, 0.01, 0.1));
        assertFalse(new EqualTimeComparison(pictures, 0, Set.of()).isEqual());
        assertEquals(
                "These pictures are not at equal time: raytrace with 10 light samples 0.11 s, cluster 0.10 s.",
                new EqualTimeComparison(pictures, 0, Set.of()).sentence().orElseThrow());
        assertTrue(new EqualTimeComparison(
                        List.of(picture("raytrace", 0.02, 0.02, 0.109), picture("cluster", 0.01, 0.01, 0.1)),
                        0,
                        Set.of())
                .isEqual());
    }

    @Test
    void theTwoMeasuresAreToldWhereTheyDisagree() {
        EqualTimePicture byFlip = picture("raytrace", 0.02, 0.01, 1);
        assertEquals(
                "At equal time (raytrace with 10 light samples 1.0 s, cluster 1.0 s) the two measures disagree: by RMSE "
                        + "cluster is nearer to the truth, by FLIP raytrace with 10 light samples.",
                sentence(byFlip, picture("cluster", 0.01, 0.02, 1)));
        assertTrue(sentence(byFlip, picture("cluster", 0.01, 0.005, 1))
                .endsWith("cluster is nearer to the truth, by RMSE and by FLIP."));
        assertTrue(sentence(byFlip, picture("cluster", 0.01, 0.0101, 1))
                .endsWith("by RMSE cluster is nearer to the truth, FLIP sees no difference."));
        assertTrue(sentence(byFlip, picture("cluster", 0.0201, 0.02, 1))
                .endsWith("by FLIP raytrace with 10 light samples is nearer to the truth, RMSE sees no difference."));
        assertTrue(sentence(byFlip, picture("cluster", 0.0201, 0.01, 1)).contains("neither is nearer to the truth"));
    }

    @Test
    void aSinglePictureIsComparedWithNothing() {
        assertTrue(new EqualTimeComparison(List.of(picture("cluster", 0.1, 0.1, 1)), 0, Set.of())
                .sentence()
                .isEmpty());
    }

    @Test
    void ofSeveralMethodsTheNearestIsNamedAndTheBlindAreNotJudged() {
        List<EqualTimePicture> all = List.of(
                picture("raytrace", 0.02, 0.02, 1),
                picture("light", 0.001, 0.001, 1),
                picture("cluster", 0.01, 0.01, 1));
        assertTrue(new EqualTimeComparison(all, 0, Set.of())
                .sentence()
                .orElseThrow()
                .endsWith(" light is nearest to the truth, by RMSE and by FLIP."));
        assertTrue(new EqualTimeComparison(all, 0, Set.of("light"))
                .sentence()
                .orElseThrow()
                .endsWith(" cluster is nearer to the truth, by RMSE and by FLIP, of those that see all of the scene."));
    }
}

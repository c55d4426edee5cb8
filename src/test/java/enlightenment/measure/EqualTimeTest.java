package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EqualTimeTest {
    /** A clock whose speed changes with every render by this factor; each method takes a start and some time for each sample. */
    private static final class FakeMeter implements EqualTimeSearch.Stopwatch {
        private final double[] start = {0.02, 0.3};
        private final double[] each = {0.1, 0.025};
        private final double drift;
        private double speed = 1;
        int renders;

        FakeMeter(double drift) {
            this.drift = drift;
        }

        double undisturbed(int contender, double samples) {
            return start[contender] + each[contender] * samples;
        }

        @Override
        public double seconds(int contender, double samples) {
            renders++;
            speed *= drift;
            return speed * undisturbed(contender, samples);
        }
    }

    /** Whatever the drift: what is called equal is equal on an undisturbed machine too, but for the curvature of the drift. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.97, 1.03, 1.1})
    void aDriftingMachineDoesNotMakeUnequalBudgetsLookEqual(double drift) {
        FakeMeter meter = new FakeMeter(drift);
        EqualTimeSearch.Found found = new EqualTimeSearch(meter, () -> true).search(new double[] {1.2, 40});
        assertTrue(found.isEqual(), found.apart() + " apart");
        double first = meter.undisturbed(0, found.samples()[0]);
        double second = meter.undisturbed(1, found.samples()[1]);
        double apart = Math.max(first / second, second / first);
        assertTrue(apart <= 1.13, apart + " apart undisturbed");
        // The slowest keeps its budget: 0.3 + 0.025 · 40 = 1.3 s.
        assertEquals(40, found.samples()[1]);
    }

    @Test
    void equalTimesAreTakenAsTheyAre() {
        FakeMeter meter = new FakeMeter(1);
        EqualTimeSearch.Found found = new EqualTimeSearch(meter, () -> true).search(new double[] {12.8, 40});
        assertArrayEquals(new double[] {12.8, 40}, found.samples());
        assertEquals(4, meter.renders);
    }

    @Test
    void whatCannotBeMadeEqualEndsAndIsNotCalledEqual() {
        int[] renders = {0};
        EqualTimeSearch.Stopwatch constant = (i, samples) -> {
            renders[0]++;
            return i == 0 ? 1 : 2;
        };
        EqualTimeSearch.Found found = new EqualTimeSearch(constant, () -> true).search(new double[] {1, 1});
        assertFalse(found.isEqual());
        assertEquals(2, found.apart());
        assertTrue(renders[0] <= 24, renders[0] + " renders");
    }

    @Test
    void withoutTimeForAnotherRoundTheFirstOneIsWhatThereIs() {
        FakeMeter meter = new FakeMeter(1);
        EqualTimeSearch.Found found = new EqualTimeSearch(meter, () -> false).search(new double[] {1, 40});
        assertFalse(found.isEqual());
        assertArrayEquals(new double[] {0.12, 1.3}, found.seconds(), 1e-12);
    }

    private static EqualTime picture(String method, double error, double flip, double seconds) {
        TradeRun run = SyntheticRuns.of(TradeRun.EQUAL_TIME, method, 10, 4, 0, error * error, seconds, flip);
        return new EqualTime(run, Optional.empty(), Optional.empty(), 1);
    }

    private static String sentence(EqualTime a, EqualTime b) {
        return EqualTime.sentence(List.of(a, b), 0).orElseThrow();
    }

    @Test
    void timesMoreThanATenthApartAreNotCalledEqual() {
        List<EqualTime> pictures = List.of(picture("raytrace", 0.02, 0.02, 0.111), picture("cluster", 0.01, 0.01, 0.1));
        assertFalse(EqualTime.areEqual(pictures));
        assertEquals(
                "These pictures are not at equal time: raytrace with 10 light points 0.11 s, cluster 0.10 s.",
                EqualTime.sentence(pictures, 0).orElseThrow());
        assertTrue(EqualTime.areEqual(
                List.of(picture("raytrace", 0.02, 0.02, 0.109), picture("cluster", 0.01, 0.01, 0.1))));
    }

    @Test
    void theTwoMeasuresAreToldWhereTheyDisagree() {
        EqualTime byFlip = picture("raytrace", 0.02, 0.01, 1);
        assertEquals(
                "At equal time (raytrace with 10 light points 1.0 s, cluster 1.0 s) the two measures disagree: by RMSE "
                        + "cluster is nearer to the truth, by FLIP raytrace with 10 light points.",
                sentence(byFlip, picture("cluster", 0.01, 0.02, 1)));
        assertTrue(sentence(byFlip, picture("cluster", 0.01, 0.005, 1))
                .endsWith("cluster is nearer to the truth, by RMSE and by FLIP."));
        assertTrue(sentence(byFlip, picture("cluster", 0.01, 0.0101, 1))
                .endsWith("by RMSE cluster is nearer to the truth, FLIP sees no difference."));
        assertTrue(sentence(byFlip, picture("cluster", 0.0201, 0.02, 1))
                .endsWith("by FLIP raytrace with 10 light points is nearer to the truth, RMSE sees no difference."));
        assertTrue(sentence(byFlip, picture("cluster", 0.0201, 0.01, 1)).contains("neither is nearer to the truth"));
    }

    @Test
    void aSinglePictureIsComparedWithNothing() {
        assertTrue(
                EqualTime.sentence(List.of(picture("cluster", 0.1, 0.1, 1)), 0).isEmpty());
    }
}

package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EqualTimeSearchTest {
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

        double undisturbed(int configuration, double samples) {
            return start[configuration] + each[configuration] * samples;
        }

        @Override
        public double seconds(int configuration, double samples) {
            renders++;
            speed *= drift;
            return speed * undisturbed(configuration, samples);
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
}

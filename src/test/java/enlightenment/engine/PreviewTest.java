package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PreviewTest {
    private static final double FIRST = 1.0 / 64;

    private static double sum(List<Double> passes) {
        return FIRST + passes.stream().mapToDouble(Double::doubleValue).sum();
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 3.9, 4, 16, 17, 66, 67, 400, 1e4, 1 << 24})
    void coarsePassesTakeAtMostAFiftiethOfTheSamplesAndOneMoreWouldTakeMore(double samples) {
        List<Double> passes = Preview.Kind.COARSE.passes(samples);
        assertTrue(sum(passes) <= samples / 50, passes.toString());
        // One pass more would have four times the samples of the last.
        double next = 4 * (passes.isEmpty() ? FIRST : passes.get(passes.size() - 1));
        assertTrue(next > 1 || sum(passes) + next > samples / 50, passes.toString());
        assertTrue(next <= 4, passes.toString());
    }

    @Test
    void eachCoarsePassHalvesTheSidesOfTheSquares() {
        assertEquals(List.of(), Preview.Kind.COARSE.passes(1));
        assertEquals(List.of(1.0 / 16), Preview.Kind.COARSE.passes(4));
        assertEquals(List.of(1.0 / 16, 1.0 / 4, 1.0), Preview.Kind.COARSE.passes(100));
        assertEquals(List.of(1.0 / 16, 1.0 / 4, 1.0), Preview.Kind.COARSE.passes(1e6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 63, 64, 400, 1e6})
    void finePassesTakeNoMoreThanTheirShare(double samples) {
        assertTrue(sum(Preview.Kind.FINE.passes(samples)) <= samples * Preview.Kind.FINE.share() + FIRST);
    }
}

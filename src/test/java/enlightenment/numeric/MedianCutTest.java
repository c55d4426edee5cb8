package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class MedianCutTest {
    /** Few different values where ties matter, or many. */
    private static double[] values(SplittableRandom r, int n) {
        int different = 1 + r.nextInt(r.nextBoolean() ? 3 : 1000);
        return r.ints(n, 0, different).mapToDouble(v -> v - 1.5).toArray();
    }

    @Test
    void afterSelectionTheItemAtThePlaceIsThatOfTheSortedRangeAndAllOthersAreOnTheirSide() {
        SplittableRandom r = new SplittableRandom(1);
        for (int round = 0; round < 2000; round++) {
            int n = 1 + r.nextInt(60);
            double[] values = values(r, n);
            int from = r.nextInt(n);
            int to = from + 1 + r.nextInt(n - from);
            int place = from + r.nextInt(to - from);
            int[] items = IntStream.range(0, n).toArray();
            MedianCut.select(items, from, to, place, i -> values[i], looked -> {});
            double[] sorted = Arrays.copyOfRange(values, from, to);
            Arrays.sort(sorted);
            assertEquals(sorted[place - from], values[items[place]]);
            for (int i = 0; i < n; i++) {
                if (i < from || i >= to) {
                    assertEquals(i, items[i], "outside of the range");
                } else {
                    double difference = values[items[i]] - values[items[place]];
                    assertTrue(i < place ? difference <= 0 : difference >= 0);
                }
            }
            int[] all = items.clone();
            Arrays.sort(all);
            assertArrayEquals(IntStream.range(0, n).toArray(), all);
        }
    }

    /** A sorted, a reversed and a constant range are halved by each pass: n + n/2 + ... looks, where a bad pivot needs n²/2. */
    @Test
    void orderedAndEqualItemsAreNoWorstCase() {
        int n = 4096;
        for (int step : new int[] {1, -1, 0}) {
            int[] items = IntStream.range(0, n).toArray();
            long[] looks = new long[1];
            MedianCut.select(items, 0, n, n / 2, i -> step * (double) i, looked -> looks[0] += looked);
            assertTrue(looks[0] <= 2L * n, looks[0] + " looks");
        }
    }

    @Test
    void whatIsToldOfAPassMayEndIt() {
        int[] items = IntStream.range(0, 9).toArray();
        assertThrows(
                CancellationException.class,
                () -> MedianCut.select(items, 0, 9, 4, i -> i, looked -> {
                    throw new CancellationException();
                }));
    }

    @Test
    void theLongestSideIsThatOfTheBoxAroundThePointsAndTheFirstOfEqualOnes() {
        double[][] points = {{0, 9, 0}, {1, 0, 0}, {3, 1, 2}, {2, 1, 4}};
        assertEquals(2, MedianCut.longestSide(1, 4, (k, axis) -> points[k][axis]));
        assertEquals(1, MedianCut.longestSide(0, 4, (k, axis) -> points[k][axis]));
        assertEquals(0, MedianCut.longestSide(2, 3, (k, axis) -> points[k][axis]), "a point has none");
    }
}

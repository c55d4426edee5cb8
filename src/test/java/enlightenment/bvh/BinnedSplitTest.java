package enlightenment.bvh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;

/** Holds the split against the plain definition: all borders between sixteen bins on each axis, each with the boxes of its two sides. */
class BinnedSplitTest {
    private static final int BINS = 16;

    /** Random boxes; on a coarse grid, so that many centroids coincide and bins are empty. */
    private static double[] boxes(int n, Random random) {
        double[] all = new double[6 * n];
        int grid = 1 << random.nextInt(9);
        boolean isFlat = random.nextInt(4) == 0;
        for (int i = 0; i < n; i++) {
            for (int a = 0; a < 3; a++) {
                double low = isFlat && a == 1 ? 0.5 : random.nextInt(grid) / (double) grid;
                all[6 * i + a] = low;
                all[6 * i + 3 + a] = low + random.nextInt(3) * 0.125;
            }
        }
        return all;
    }

    private static double[] box(double[] boxes, IntPredicate isIn) {
        double[] box = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        for (int i = 0; 6 * i < boxes.length; i++) {
            for (int a = 0; a < 3 && isIn.test(i); a++) {
                box[a] = Math.min(box[a], boxes[6 * i + a]);
                box[3 + a] = Math.max(box[3 + a], boxes[6 * i + 3 + a]);
            }
        }
        return box;
    }

    private static double center(double[] boxes, int i, int a) {
        return (boxes[6 * i + a] + boxes[6 * i + 3 + a]) / 2;
    }

    private static int[] bins(double[] boxes, int a) {
        int n = boxes.length / 6;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < n; i++) {
            low = Math.min(low, center(boxes, i, a));
            high = Math.max(high, center(boxes, i, a));
        }
        int[] bins = new int[n];
        for (int i = 0; i < n; i++) {
            bins[i] = low == high ? 0 : Math.min(BINS - 1, (int) ((center(boxes, i, a) - low) * (BINS / (high - low))));
        }
        return bins;
    }

    /** The lowest cost of any border on any axis, infinite if there is none with items on both sides. */
    private static double lowestCost(double[] boxes, ItemBoxes items) {
        int n = boxes.length / 6;
        double lowest = Double.POSITIVE_INFINITY;
        for (int a = 0; a < 3; a++) {
            int[] bins = bins(boxes, a);
            for (int k = 1; k < BINS; k++) {
                int border = k;
                int below = (int) Arrays.stream(bins).filter(b -> b < border).count();
                if (below > 0 && below < n) {
                    double cost = below * items.area(box(boxes, i -> bins[i] < border), 0)
                            + (n - below) * items.area(box(boxes, i -> bins[i] >= border), 0);
                    lowest = Math.min(lowest, cost);
                }
            }
        }
        return lowest;
    }

    @Test
    void theSplitIsTheCheapestOfAllBorders() {
        Random random = new Random(3);
        int unsplit = 0;
        for (int round = 0; round < 4000; round++) {
            int n = 1 + random.nextInt(round % 10 == 0 ? 300 : 12);
            double[] boxes = boxes(n, random);
            ItemBoxes items = new ItemBoxes(n, (i, out, at) -> System.arraycopy(boxes, 6 * i, out, at, 6));
            BinnedSplit split = new BinnedSplit(items);
            double[] box = new double[6];
            split.measure(0, n, box);
            assertTrue(Arrays.equals(box(boxes, i -> true), box));
            double expected = lowestCost(boxes, items);
            assertEquals(expected < Double.POSITIVE_INFINITY, split.find(0, n));
            assertEquals(expected, split.cost());
            if (expected == Double.POSITIVE_INFINITY) {
                unsplit++;
                continue;
            }
            int middle = split.partition(0, n);
            boolean[] isLower = new boolean[n];
            for (int place = 0; place < middle; place++) {
                isLower[items.ids()[place]] = true;
            }
            assertTrue(middle > 0 && middle < n);
            double cost = middle * items.area(box(boxes, i -> isLower[i]), 0)
                    + (n - middle) * items.area(box(boxes, i -> !isLower[i]), 0);
            assertEquals(expected, cost);
        }
        assertTrue(unsplit > 100 && unsplit < 2000, unsplit + " ranges could not be split");
    }
}

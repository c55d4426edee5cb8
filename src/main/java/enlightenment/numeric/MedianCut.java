package enlightenment.numeric;

import java.util.function.IntConsumer;
import java.util.function.IntToDoubleFunction;

/** How a tree over points cuts a group of them in two: across the longest side of the box around them, at the median. */
public final class MedianCut {
    private MedianCut() {}

    /** A coordinate of a point. */
    public interface Coordinates {
        /**
         * The coordinate.
         *
         * @param point the point's number
         * @param axis 0..2
         */
        double of(int point, int axis);
    }

    /** The axis, 0..2, of the points with the numbers from the first on and before the end; the first one of those with equal sides. */
    public static int longestSide(int first, int end, Coordinates coordinates) {
        int longest = 0;
        double length = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double greatest = Double.NEGATIVE_INFINITY;
            for (int k = first; k < end; k++) {
                double coordinate = coordinates.of(k, axis);
                least = Math.min(least, coordinate);
                greatest = Math.max(greatest, coordinate);
            }
            if (greatest - least > length) {
                length = greatest - least;
                longest = axis;
            }
        }
        return longest;
    }

    /**
     * Orders a range of items so that none before a place has a larger coordinate than one from there on (C. A. R. Hoare, "Algorithm 65:
     * Find", 1961). Time is linear in the mean.
     *
     * @param items orders these from {@code from} on and before {@code to}
     * @param place from {@code from} on and before {@code to}
     * @param along an item's coordinate, not NaN
     * @param passes receives the number of items before each pass over them; may throw
     */
    public static void select(int[] items, int from, int to, int place, IntToDoubleFunction along, IntConsumer passes) {
        int low = from;
        int high = to - 1;
        while (low < high) {
            passes.accept(high - low);
            double pivot = along.applyAsDouble(items[(low + high) >>> 1]);
            int i = low;
            int k = high;
            while (i <= k) {
                while (along.applyAsDouble(items[i]) < pivot) {
                    i++;
                }
                while (along.applyAsDouble(items[k]) > pivot) {
                    k--;
                }
                if (i <= k) {
                    int item = items[i];
                    items[i++] = items[k];
                    items[k--] = item;
                }
            }
            if (place <= k) {
                high = k;
            } else if (place >= i) {
                low = i;
            } else {
                return;
            }
        }
    }
}

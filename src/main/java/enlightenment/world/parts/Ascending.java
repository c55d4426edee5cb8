package enlightenment.world.parts;

import java.util.Arrays;

/** The order of many numbers, without an object for any of them. */
public final class Ascending {
    private Ascending() {}

    /** The indices of the numbers in ascending order, as {@link Double#compare} has it; equal ones keep theirs. */
    public static int[] order(double[] numbers) {
        long[] sorted = new long[numbers.length];
        for (int i = 0; i < sorted.length; i++) {
            sorted[i] = comparable(numbers[i]);
        }
        Arrays.sort(sorted);
        int[] order = new int[sorted.length];
        int[] equals = new int[sorted.length];
        for (int i = 0; i < order.length; i++) {
            int first = first(sorted, comparable(numbers[i]));
            order[first + equals[first]++] = i;
        }
        return order;
    }

    /** A whole number that compares with others as the double does. */
    private static long comparable(double v) {
        long bits = Double.doubleToLongBits(v);
        return bits ^ bits >> 63 & Long.MAX_VALUE;
    }

    /** Where a number that is there stands first. */
    private static int first(long[] sorted, long number) {
        int low = 0;
        int high = sorted.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted[middle] < number) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }
}

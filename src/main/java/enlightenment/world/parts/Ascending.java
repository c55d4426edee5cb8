package enlightenment.world.parts;

import java.util.Arrays;

/** Sorts indices by many numbers, without an object for any of them. */
public final class Ascending {
    /** Bits of a digit of the radix sort: the counts of its values fit into the processor's first-level cache. */
    private static final int BITS = 11;

    private static final int RADIX = 1 << BITS;
    private static final int DIGITS = (Long.SIZE + BITS - 1) / BITS;

    private Ascending() {}

    /** The indices of the numbers in ascending order, as {@link Double#compare} has it; equal ones keep theirs. */
    public static int[] order(double[] numbers) {
        int n = numbers.length;
        if (n < RADIX) {
            return orderOfFew(numbers);
        }
        long[] keys = new long[n];
        int[] order = new int[n];
        int[][] counts = new int[DIGITS][RADIX];
        for (int i = 0; i < n; i++) {
            keys[i] = comparable(numbers[i]) ^ Long.MIN_VALUE;
            order[i] = i;
            for (int digit = 0; digit < DIGITS; digit++) {
                counts[digit][digit(keys[i], digit)]++;
            }
        }
        int[] other = new int[n];
        for (int digit = 0; digit < DIGITS; digit++) {
            // A digit that all keys share sorts nothing; most numbers of a scene share some.
            if (counts[digit][digit(keys[0], digit)] < n) {
                sort(keys, digit, counts[digit], order, other);
                int[] sorted = other;
                other = order;
                order = sorted;
            }
        }
        return order;
    }

    /** The order of few numbers, by a search for each in the sorted numbers, which is faster than a radix sort. */
    private static int[] orderOfFew(double[] numbers) {
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

    /** One pass of a radix sort, from the least significant digit on: sorts by a digit, and what is equal in that keeps its order. */
    private static void sort(long[] keys, int digit, int[] counts, int[] order, int[] sorted) {
        int next = 0;
        for (int d = 0; d < RADIX; d++) {
            int count = counts[d];
            counts[d] = next;
            next += count;
        }
        for (int i : order) {
            sorted[counts[digit(keys[i], digit)]++] = i;
        }
    }

    /** A digit of a key, counted from the least significant one. */
    private static int digit(long key, int digit) {
        return (int) (key >>> digit * BITS) & RADIX - 1;
    }

    /** An integer that is ordered as the double is. */
    private static long comparable(double v) {
        long bits = Double.doubleToLongBits(v);
        return bits ^ bits >> 63 & Long.MAX_VALUE;
    }

    /** The first index of a number that occurs. */
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

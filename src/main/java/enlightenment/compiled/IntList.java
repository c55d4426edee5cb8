package enlightenment.compiled;

import java.util.Arrays;

/** A growing list of numbers that is used again. */
final class IntList {
    private int[] numbers = new int[16];
    private int size;

    void clear() {
        size = 0;
    }

    void add(int number) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        numbers[size++] = number;
    }

    int size() {
        return size;
    }

    int get(int k) {
        return numbers[k];
    }

    void set(int k, int number) {
        numbers[k] = number;
    }

    /** Keeps the first n. */
    void shorten(int n) {
        size = n;
    }

    /** Ascending. */
    void sort() {
        Arrays.sort(numbers, 0, size);
    }
}

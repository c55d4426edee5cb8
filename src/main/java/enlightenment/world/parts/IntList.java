package enlightenment.world.parts;

import java.util.Arrays;

/** A growing list of ints that is reused. */
public final class IntList {
    private int[] numbers = new int[16];
    private int size;

    public void clear() {
        size = 0;
    }

    public void add(int number) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        numbers[size++] = number;
    }

    public int size() {
        return size;
    }

    public int get(int k) {
        return numbers[k];
    }

    public void set(int k, int number) {
        numbers[k] = number;
    }

    /** Keeps the first n elements. */
    public void shorten(int n) {
        size = n;
    }

    /** Sorts the elements in ascending order. */
    public void sort() {
        Arrays.sort(numbers, 0, size);
    }
}

package enlightenment.mesh;

import java.util.Arrays;

/** A list of integers that grows. */
final class Ints {
    private int[] values;
    private int size;

    Ints(int capacity) {
        values = new int[capacity];
    }

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, Floats.larger(size));
        }
        values[size++] = value;
    }

    int get(int i) {
        return values[i];
    }

    int size() {
        return size;
    }

    /** The values as an array, which is not copied if it is full. */
    int[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }
}

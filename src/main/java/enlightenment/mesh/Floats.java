package enlightenment.mesh;

import enlightenment.check.Check;
import java.util.Arrays;

/** A list of floats that grows. */
final class Floats {
    /** Somewhat below the longest array that there can be. */
    static final int LONGEST = Integer.MAX_VALUE - 64;

    private float[] values;
    private int size;

    Floats(int capacity) {
        values = new float[capacity];
    }

    void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, larger(size));
        }
        values[size++] = value;
    }

    float get(int i) {
        return values[i];
    }

    int size() {
        return size;
    }

    /** The values as an array, which is not copied if it is full. */
    float[] toArray() {
        return size == values.length ? values : Arrays.copyOf(values, size);
    }

    /** A longer length for an array that is full. */
    static int larger(int length) {
        Check.that(length < LONGEST, "mesh", "has more numbers than an array can hold");
        return (int) Math.min(LONGEST, length + (long) length / 2 + 8);
    }
}

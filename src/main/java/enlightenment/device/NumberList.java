package enlightenment.device;

import java.util.Arrays;

/** Arrays that grow; what is added is found again where adding it said. */
final class NumberList {
    private NumberList() {}

    private static int grown(int needed) {
        return Math.max(16, Math.addExact(needed, needed / 2));
    }

    static final class Doubles {
        private double[] numbers = {};
        private int size;

        /** Adds numbers; returns where the first one is. */
        int add(double... more) {
            if (size + more.length > numbers.length) {
                numbers = Arrays.copyOf(numbers, grown(size + more.length));
            }
            System.arraycopy(more, 0, numbers, size, more.length);
            size += more.length;
            return size - more.length;
        }

        void set(int place, double value) {
            numbers[place] = value;
        }

        double get(int place) {
            return numbers[place];
        }

        double[] toArray() {
            return Arrays.copyOf(numbers, size);
        }
    }

    static final class Ints {
        private int[] numbers = {};
        private int size;

        /** Adds numbers; returns where the first one is. */
        int add(int... more) {
            if (size + more.length > numbers.length) {
                numbers = Arrays.copyOf(numbers, grown(size + more.length));
            }
            System.arraycopy(more, 0, numbers, size, more.length);
            size += more.length;
            return size - more.length;
        }

        void set(int place, int value) {
            numbers[place] = value;
        }

        int get(int place) {
            return numbers[place];
        }

        int[] toArray() {
            return Arrays.copyOf(numbers, size);
        }
    }

    static final class Floats {
        private float[] numbers = {};
        private int size;

        /** Adds numbers; returns where the first one is. */
        int add(float... more) {
            if (size + more.length > numbers.length) {
                numbers = Arrays.copyOf(numbers, grown(size + more.length));
            }
            System.arraycopy(more, 0, numbers, size, more.length);
            size += more.length;
            return size - more.length;
        }

        float[] toArray() {
            return Arrays.copyOf(numbers, size);
        }
    }
}

package enlightenment.importer.pbrt;

import java.util.Arrays;

/** A list of numbers that grows, and how they are written. */
final class Numbers {
    /** The most numbers in one list: 1 GiB of them. */
    static final int MOST = 1 << 27;

    private double[] values = new double[8];
    private int size;

    /** @return whether there was room */
    boolean add(double value) {
        if (size == MOST) {
            return false;
        }
        if (size == values.length) {
            values = Arrays.copyOf(values, Math.min(2 * size, MOST));
        }
        values[size++] = value;
        return true;
    }

    int size() {
        return size;
    }

    double[] toArray() {
        return Arrays.copyOf(values, size);
    }

    /** The number that a word is: decimal, with or without an exponent; NaN if it is none. */
    static double parse(String word) {
        if (word.isEmpty() || "+-.0123456789".indexOf(word.charAt(0)) < 0) {
            return Double.NaN;
        }
        char end = word.charAt(word.length() - 1);
        boolean isDecimal = end >= '0' && end <= '9' || end == '.';
        if (!isDecimal || word.indexOf('x') >= 0 || word.indexOf('X') >= 0) {
            return Double.NaN;
        }
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}

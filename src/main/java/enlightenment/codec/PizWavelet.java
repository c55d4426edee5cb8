package enlightenment.codec;

/**
 * The wavelet transform of PIZ, undone in place: a two-dimensional Haar transform in lifting form, which maps whole numbers to whole
 * numbers. At each level, samples that are {@code step} apart hold mean and difference.
 */
final class PizWavelet {
    /** Below this number of values no sum or difference leaves 16 bits. */
    private static final int SMALL = 1 << 14;

    private static final int MASK = 0xffff;
    private static final int OFFSET = 1 << 15;

    private final char[] data;
    private final int start;
    private final int columns;
    private final int columnStride;
    private final int rows;
    private final int rowStride;
    private final boolean isModular;

    /**
     * A plane of samples within an array.
     *
     * @param start index of the first sample
     * @param stride from a sample to its right neighbour; rows follow each other without gaps
     * @param values the number of values that samples had before the transform: from 2^14 on it was computed modulo 2^16
     */
    PizWavelet(char[] data, int start, int columns, int stride, int rows, int values) {
        this.data = data;
        this.start = start;
        this.columns = columns;
        this.columnStride = stride;
        this.rows = rows;
        this.rowStride = stride * columns;
        isModular = values - 1 >= SMALL;
    }

    /** Undoes the transform, the coarsest level first. */
    void invert() {
        for (int step = Integer.highestOneBit(Math.min(columns, rows)) >> 1; step >= 1; step >>= 1) {
            invert(step);
        }
    }

    private void invert(int step) {
        int right = step * columnStride;
        int below = step * rowStride;
        int y = 0;
        for (; y + 2 * step <= rows; y += 2 * step) {
            int at = start + y * rowStride;
            int x = 0;
            for (; x + 2 * step <= columns; x += 2 * step) {
                merge(at, at + below);
                merge(at + right, at + right + below);
                merge(at, at + right);
                merge(at + below, at + below + right);
                at += 2 * right;
            }
            if ((columns & step) != 0) {
                merge(at, at + below);
            }
        }
        if ((rows & step) != 0) {
            int at = start + y * rowStride;
            for (int x = 0; x + 2 * step <= columns; x += 2 * step) {
                merge(at, at + right);
                at += 2 * right;
            }
        }
    }

    /** Makes two samples of their mean, at the first index, and their difference, at the second. */
    private void merge(int first, int second) {
        if (isModular) {
            int mean = data[first];
            int difference = data[second];
            int b = mean - (difference >> 1) & MASK;
            data[first] = (char) (difference + b - OFFSET & MASK);
            data[second] = (char) b;
        } else {
            int difference = (short) data[second];
            int a = (short) data[first] + (difference & 1) + (difference >> 1);
            data[first] = (char) a;
            data[second] = (char) (a - difference);
        }
    }
}

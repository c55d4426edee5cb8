package enlightenment.bvh;

import enlightenment.frame.Bounds;
import enlightenment.numeric.Scale;
import java.util.function.IntFunction;

/** Boxes of items in one flat array that is rearranged while a hierarchy is built, so that siblings are adjacent. */
public final class ItemBoxes {
    /** Numbers of a box: its lower corner, its upper corner. */
    public static final int BOX = 6;

    private final double[] b;
    private final int[] ids;

    /** A power of two that extents are multiplied by before areas are computed, so that these stay in range. */
    private final double unit;

    private final double reach;

    /** Sets the box of an item: the six numbers at out[at]. */
    public interface Boxes {
        void set(int item, double[] out, int at);
    }

    /** @param boxes by item */
    public ItemBoxes(int n, IntFunction<Bounds> boxes) {
        this(n, (i, out, at) -> set(boxes.apply(i), out, at));
    }

    /** @param boxes writes the box of an item */
    public ItemBoxes(int n, Boxes boxes) {
        b = new double[BOX * n];
        ids = new int[n];
        double largest = 0;
        for (int i = 0; i < n; i++) {
            ids[i] = i;
            boxes.set(i, b, BOX * i);
            for (int k = BOX * i; k < BOX * i + BOX; k++) {
                largest = Math.max(largest, Math.abs(b[k]));
            }
        }
        reach = largest;
        // Clamped so that the factor itself is a normal number.
        unit = Math.scalb(1.0, -Math.max(-1000, Math.min(1000, Scale.exponent(reach))));
    }

    private static void set(Bounds box, double[] out, int at) {
        out[at] = box.min().x();
        out[at + 1] = box.min().y();
        out[at + 2] = box.min().z();
        out[at + 3] = box.max().x();
        out[at + 4] = box.max().y();
        out[at + 5] = box.max().z();
    }

    /** The number of items. */
    int size() {
        return ids.length;
    }

    /** The largest absolute coordinate. */
    double reach() {
        return reach;
    }

    int[] ids() {
        return ids;
    }

    /** The centroid of item i on an axis, without overflow. */
    double center(int i, int axis) {
        return 0.5 * b[6 * i + axis] + 0.5 * b[6 * i + 3 + axis];
    }

    /** Widens the ranges of the three coordinates, each at least lowest and at most highest, by the centroids of start..end−1. */
    void encloseCenters(int start, int end, double[] lowest, double[] highest) {
        for (int axis = 0; axis < 3; axis++) {
            double low = lowest[axis];
            double high = highest[axis];
            for (int k = BOX * start + axis; k < BOX * end; k += BOX) {
                double c = 0.5 * b[k] + 0.5 * b[k + 3];
                low = c < low ? c : low;
                high = c > high ? c : high;
            }
            lowest[axis] = low;
            highest[axis] = high;
        }
    }

    /** Sets the six numbers at out[at] to the box of the items start..end−1. */
    void enclose(int start, int end, double[] out, int at) {
        clear(out, at);
        for (int i = start; i < end; i++) {
            add(i, out, at);
        }
    }

    /** Sets the six numbers at out[at] to the box that encloses nothing. */
    public static void clear(double[] out, int at) {
        for (int k = 0; k < 3; k++) {
            out[at + k] = Double.POSITIVE_INFINITY;
            out[at + 3 + k] = Double.NEGATIVE_INFINITY;
        }
    }

    /** Enlarges the box at out[at] by item i. */
    void add(int i, double[] out, int at) {
        merge(b, 6 * i, out, at);
    }

    /** Enlarges the box at out[at] by the box at in[from]. */
    public static void merge(double[] in, int from, double[] out, int at) {
        for (int k = 0; k < 3; k++) {
            if (in[from + k] < out[at + k]) {
                out[at + k] = in[from + k];
            }
            if (in[from + 3 + k] > out[at + 3 + k]) {
                out[at + 3 + k] = in[from + 3 + k];
            }
        }
    }

    /** Half the surface area of the box at box[at], in a unit that is the same for the whole scene. */
    double area(double[] box, int at) {
        double x = (box[at + 3] - box[at]) * unit;
        double y = (box[at + 4] - box[at + 1]) * unit;
        double z = (box[at + 5] - box[at + 2]) * unit;
        return x * y + y * z + z * x;
    }

    void swap(int i, int j) {
        int id = ids[i];
        ids[i] = ids[j];
        ids[j] = id;
        int p = 6 * i;
        int q = 6 * j;
        for (int k = 0; k < 6; k++) {
            double v = b[p + k];
            b[p + k] = b[q + k];
            b[q + k] = v;
        }
    }

    /** Enlarges the box at out[at] by another. */
    public static void merge(Bounds box, double[] out, int at) {
        double[] numbers = new double[BOX];
        set(box, numbers, 0);
        merge(numbers, 0, out, at);
    }

    /** Partitions start..end−1 so that no centroid before position m exceeds one from m on, on the axis (Hoare's select). */
    void select(int start, int end, int m, int axis) {
        int lo = start;
        int hi = end - 1;
        while (lo < hi) {
            double pivot = center((lo + hi) >>> 1, axis);
            int i = lo;
            int j = hi;
            while (i <= j) {
                while (center(i, axis) < pivot) {
                    i++;
                }
                while (center(j, axis) > pivot) {
                    j--;
                }
                if (i <= j) {
                    swap(i++, j--);
                }
            }
            if (m <= j) {
                hi = j;
            } else if (m >= i) {
                lo = i;
            } else {
                return;
            }
        }
    }
}

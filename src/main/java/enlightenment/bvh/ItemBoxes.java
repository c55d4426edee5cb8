package enlightenment.bvh;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import java.util.function.IntFunction;

/** Boxes of items in one flat array that is rearranged while a hierarchy is built, so that siblings are adjacent. */
public final class ItemBoxes {
    /** Numbers of a box: its lower corner, its upper corner. */
    public static final int BOX = 6;

    private final double[] b;
    private final int[] ids;

    /** The power of two that extents are multiplied by before areas are computed, so that areas stay in range. */
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
        Vec3 min = box.min();
        Vec3 max = box.max();
        set(out, at, min.x(), min.y(), min.z(), max.x(), max.y(), max.z());
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

    /** The centroid of item i on an axis, computed without overflow. */
    double center(int i, int axis) {
        return 0.5 * b[6 * i + axis] + 0.5 * b[6 * i + 3 + axis];
    }

    /** The boxes, {@link #BOX} numbers each, in the current order of the items; for this package, not to be changed. */
    double[] numbers() {
        return b;
    }

    /**
     * Measures items start..end−1 in one pass.
     *
     * @param out receives the box that encloses them, then the box of their centroids
     */
    void measure(int start, int end, double[] out) {
        double x0 = Double.POSITIVE_INFINITY;
        double y0 = x0;
        double z0 = x0;
        double x1 = Double.NEGATIVE_INFINITY;
        double y1 = x1;
        double z1 = x1;
        double u0 = x0;
        double v0 = x0;
        double w0 = x0;
        double u1 = x1;
        double v1 = x1;
        double w1 = x1;
        for (int p = BOX * start; p < BOX * end; p += BOX) {
            double u = 0.5 * b[p] + 0.5 * b[p + 3];
            double v = 0.5 * b[p + 1] + 0.5 * b[p + 4];
            double w = 0.5 * b[p + 2] + 0.5 * b[p + 5];
            u0 = u < u0 ? u : u0;
            v0 = v < v0 ? v : v0;
            w0 = w < w0 ? w : w0;
            u1 = u > u1 ? u : u1;
            v1 = v > v1 ? v : v1;
            w1 = w > w1 ? w : w1;
            x0 = b[p] < x0 ? b[p] : x0;
            y0 = b[p + 1] < y0 ? b[p + 1] : y0;
            z0 = b[p + 2] < z0 ? b[p + 2] : z0;
            x1 = b[p + 3] > x1 ? b[p + 3] : x1;
            y1 = b[p + 4] > y1 ? b[p + 4] : y1;
            z1 = b[p + 5] > z1 ? b[p + 5] : z1;
        }
        set(out, 0, x0, y0, z0, x1, y1, z1);
        set(out, BOX, u0, v0, w0, u1, v1, w1);
    }

    /** Sets the six numbers at out[at]. */
    static void set(double[] out, int at, double x0, double y0, double z0, double x1, double y1, double z1) {
        out[at] = x0;
        out[at + 1] = y0;
        out[at + 2] = z0;
        out[at + 3] = x1;
        out[at + 4] = y1;
        out[at + 5] = z1;
    }

    /** Sets the six numbers at out[at] to the box that encloses nothing. */
    public static void clear(double[] out, int at) {
        for (int k = 0; k < 3; k++) {
            out[at + k] = Double.POSITIVE_INFINITY;
            out[at + 3 + k] = Double.NEGATIVE_INFINITY;
        }
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
        return area(box[at + 3] - box[at], box[at + 4] - box[at + 1], box[at + 5] - box[at + 2]);
    }

    /** {@link #area(double[], int)} by the extents of the box. */
    double area(double width, double height, double depth) {
        double x = width * unit;
        double y = height * unit;
        double z = depth * unit;
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

package enlightenment.accel;

import enlightenment.geometry.Primitive;
import enlightenment.math.Bounds;
import java.util.Arrays;

/**
 * Builds a {@link Bvh} top down by the surface area heuristic over bins (Wald, "On fast construction of SAH-based bounding
 * volume hierarchies", 2007). Deterministic: it depends on the primitives only.
 */
final class BvhBuilder {
    private static final int LEAF_SIZE = 4;
    private static final int BINS = 16;

    /** Below this depth nodes are halved by number, which ends at depth MAX_DEPTH for any number of primitives. */
    private static final int HEURISTIC_DEPTH = 60;

    private final Primitive[] primitives;
    private final int[] order;
    private final double[] bounds;
    private double[] boxes;
    private int[] links;
    private byte[] counts;
    private int nodes;

    private final int[] binCounts = new int[BINS];
    private final double[] binBoxes = new double[6 * BINS];
    private final double[] rightAreas = new double[BINS];
    private final double[] box = new double[6];
    private final double[] centers = new double[6];

    BvhBuilder(Primitive[] primitives) {
        this.primitives = primitives;
        order = new int[primitives.length];
        bounds = new double[6 * primitives.length];
        for (int i = 0; i < primitives.length; i++) {
            order[i] = i;
            Bounds b = primitives[i].bounds();
            for (int c = 0; c < 3; c++) {
                bounds[6 * i + c] = b.min().component(c);
                bounds[6 * i + 3 + c] = b.max().component(c);
            }
        }
        int capacity = Math.max(2 * primitives.length, 1);
        boxes = new double[6 * capacity];
        links = new int[capacity];
        counts = new byte[capacity];
    }

    Bvh build() {
        if (primitives.length > 0) {
            split(0, primitives.length, 0);
        }
        return new Bvh(
                primitives,
                order,
                Arrays.copyOf(boxes, 6 * nodes),
                Arrays.copyOf(links, nodes),
                Arrays.copyOf(counts, nodes));
    }

    /** Makes the node of order[from..to) and everything below it. The depth is bounded, so recursion is safe. */
    private void split(int from, int to, int depth) {
        int node = nodes++;
        measure(from, to);
        System.arraycopy(box, 0, boxes, 6 * node, 6);
        if (to - from <= LEAF_SIZE) {
            links[node] = -1 - from;
            counts[node] = (byte) (to - from);
            return;
        }
        int middle = depth < HEURISTIC_DEPTH ? partition(from, to) : (from + to) >>> 1;
        split(from, middle, depth + 1);
        links[node] = nodes;
        split(middle, to, depth + 1);
    }

    /** Sets the box around order[from..to) and the box around the centres (times two, which changes no comparison). */
    private void measure(int from, int to) {
        for (int c = 0; c < 3; c++) {
            box[c] = Double.POSITIVE_INFINITY;
            box[c + 3] = Double.NEGATIVE_INFINITY;
            centers[c] = Double.POSITIVE_INFINITY;
            centers[c + 3] = Double.NEGATIVE_INFINITY;
        }
        for (int i = from; i < to; i++) {
            int k = 6 * order[i];
            for (int c = 0; c < 3; c++) {
                double lo = bounds[k + c];
                double hi = bounds[k + c + 3];
                double twice = lo + hi;
                box[c] = lo < box[c] ? lo : box[c];
                box[c + 3] = hi > box[c + 3] ? hi : box[c + 3];
                centers[c] = twice < centers[c] ? twice : centers[c];
                centers[c + 3] = twice > centers[c + 3] ? twice : centers[c + 3];
            }
        }
    }

    /** Reorders order[from..to) so that the cheapest split lies at the returned index. */
    private int partition(int from, int to) {
        int axis = 0;
        for (int c = 1; c < 3; c++) {
            if (centers[c + 3] - centers[c] > centers[axis + 3] - centers[axis]) {
                axis = c;
            }
        }
        double origin = centers[axis];
        double extent = centers[axis + 3] - origin;
        if (!(extent > 0)) {
            return (from + to) >>> 1;
        }
        double scale = BINS / extent;
        fillBins(from, to, axis, origin, scale);
        int best = cheapestSplit();
        int left = from;
        int right = to - 1;
        while (left <= right) {
            if (bin(order[left], axis, origin, scale) <= best) {
                left++;
            } else {
                int swap = order[left];
                order[left] = order[right];
                order[right--] = swap;
            }
        }
        return left > from && left < to ? left : (from + to) >>> 1;
    }

    private int bin(int id, int axis, double origin, double scale) {
        double twice = bounds[6 * id + axis] + bounds[6 * id + axis + 3];
        return Math.min((int) ((twice - origin) * scale), BINS - 1);
    }

    private void fillBins(int from, int to, int axis, double origin, double scale) {
        Arrays.fill(binCounts, 0);
        for (int b = 0; b < BINS; b++) {
            for (int c = 0; c < 3; c++) {
                binBoxes[6 * b + c] = Double.POSITIVE_INFINITY;
                binBoxes[6 * b + c + 3] = Double.NEGATIVE_INFINITY;
            }
        }
        for (int i = from; i < to; i++) {
            int b = bin(order[i], axis, origin, scale);
            binCounts[b]++;
            enclose(binBoxes, 6 * b, bounds, 6 * order[i]);
        }
    }

    /** The last bin of the left half. */
    private int cheapestSplit() {
        double[] running = new double[6];
        empty(running);
        for (int b = BINS - 1; b > 0; b--) {
            enclose(running, 0, binBoxes, 6 * b);
            rightAreas[b] = area(running);
        }
        empty(running);
        int total = 0;
        for (int n : binCounts) {
            total += n;
        }
        int left = 0;
        int best = 0;
        double bestCost = Double.POSITIVE_INFINITY;
        for (int b = 0; b < BINS - 1; b++) {
            enclose(running, 0, binBoxes, 6 * b);
            left += binCounts[b];
            double cost = left * area(running) + (total - left) * rightAreas[b + 1];
            if (left > 0 && left < total && cost < bestCost) {
                bestCost = cost;
                best = b;
            }
        }
        return best;
    }

    private static void empty(double[] box) {
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
    }

    private static void enclose(double[] into, int at, double[] other, int from) {
        for (int c = 0; c < 3; c++) {
            into[at + c] = Math.min(into[at + c], other[from + c]);
            into[at + c + 3] = Math.max(into[at + c + 3], other[from + c + 3]);
        }
    }

    /** Half the surface; 0 for an empty box. */
    private static double area(double[] box) {
        double x = box[3] - box[0];
        double y = box[4] - box[1];
        double z = box[5] - box[2];
        return x >= 0 ? x * y + y * z + z * x : 0;
    }
}

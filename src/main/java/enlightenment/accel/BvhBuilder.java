package enlightenment.accel;

import enlightenment.primitive.Primitive;
import java.util.Arrays;

/**
 * Builds a {@link Bvh} top-down: a node is split where the surface area heuristic, evaluated at the borders of equal bins
 * of centroids on each axis, expects the least work (Wald, "On fast construction of SAH-based bounding volume hierarchies",
 * 2007). One thread, plain arithmetic: the same tree on every machine.
 *
 * <p>Where no such split exists (all centroids coincide), or where the tree is so deep that it has degenerated, a node is
 * split at the median, so the depth is bounded whatever the scene.
 */
final class BvhBuilder {
    private static final int MAX_LEAF = 4;

    /** From this depth on, nodes are split at the median: 2^31 primitives then end before {@link Bvh#MAX_DEPTH}. */
    private static final int MEDIAN_DEPTH = Bvh.MAX_DEPTH - 32;

    /** The cost of visiting a node, in tests of primitives. */
    private static final double NODE_COST = 2;

    private final PrimitiveBoxes items;
    private final BinnedSplit split;
    private final Primitive[] primitives;
    private double[] boxes;
    private int[] link;
    private int[] count;
    private int nodes;

    BvhBuilder(Primitive[] original) {
        items = new PrimitiveBoxes(original);
        split = new BinnedSplit(items);
        int capacity = Math.max(1, original.length);
        boxes = new double[6 * capacity];
        link = new int[capacity];
        count = new int[capacity];
        if (original.length > 0) {
            grow(original.length);
        }
        boxes = Arrays.copyOf(boxes, 6 * nodes);
        link = Arrays.copyOf(link, nodes);
        count = Arrays.copyOf(count, nodes);
        primitives = new Primitive[original.length];
        for (int i = 0; i < primitives.length; i++) {
            primitives[i] = original[items.id(i)];
        }
    }

    /** Makes the nodes in depth-first order, with a stack of ranges (start, end, depth, parent) instead of recursion. */
    private void grow(int n) {
        int[] todo = new int[4 * (Bvh.MAX_DEPTH + 1)];
        int top = push(todo, 0, 0, n, 0, -1);
        while (top > 0) {
            top -= 4;
            int start = todo[top];
            int end = todo[top + 1];
            int depth = todo[top + 2];
            int parent = todo[top + 3];
            int node = newNode(start, end);
            if (parent >= 0) {
                link[parent] = node;
            }
            int middle = split(node, start, end, depth);
            if (middle < 0) {
                link[node] = start;
                count[node] = end - start;
            } else {
                // The left part is popped next and becomes the next node; only the right one must be linked.
                top = push(todo, top, middle, end, depth + 1, node);
                top = push(todo, top, start, middle, depth + 1, -1);
            }
        }
    }

    private static int push(int[] todo, int top, int start, int end, int depth, int parent) {
        todo[top] = start;
        todo[top + 1] = end;
        todo[top + 2] = depth;
        todo[top + 3] = parent;
        return top + 4;
    }

    private int newNode(int start, int end) {
        if (nodes == link.length) {
            int capacity = (int) Math.min(2L * nodes, Integer.MAX_VALUE / 6);
            boxes = Arrays.copyOf(boxes, 6 * capacity);
            link = Arrays.copyOf(link, capacity);
            count = Arrays.copyOf(count, capacity);
        }
        items.enclose(start, end, boxes, 6 * nodes);
        return nodes++;
    }

    /** Splits a range and partitions its items; returns where the second part begins, -1 if the range becomes a leaf. */
    private int split(int node, int start, int end, int depth) {
        int n = end - start;
        if (n == 1) {
            return -1;
        }
        if (depth < MEDIAN_DEPTH && split.find(start, end)) {
            double whole = items.area(boxes, 6 * node);
            if (n <= MAX_LEAF && n * whole <= NODE_COST * whole + split.cost()) {
                return -1;
            }
            return split.partition(start, end);
        }
        if (n <= MAX_LEAF) {
            return -1;
        }
        int middle = (start + end) >>> 1;
        items.select(start, end, middle, split.widestAxis(start, end));
        return middle;
    }

    Primitive[] primitives() {
        return primitives;
    }

    int[] ids() {
        return items.ids();
    }

    double[] boxes() {
        return boxes;
    }

    int[] link() {
        return link;
    }

    int[] count() {
        return count;
    }

    /** For each node the node after its subtree; parents come before their children, so one pass is enough. */
    int[] skip() {
        int[] skip = new int[nodes];
        if (nodes > 0) {
            skip[0] = nodes;
        }
        for (int i = 0; i < nodes; i++) {
            if (count[i] == 0) {
                skip[i + 1] = link[i];
                skip[link[i]] = skip[i];
            }
        }
        return skip;
    }
}

package enlightenment.bvh;

import java.util.Arrays;

/**
 * Builds a hierarchy in the layout of {@link Nodes}, top-down: a range of items is split where the surface area heuristic, evaluated at the borders of equal bins
 * of centroids on each axis, expects the least work (Wald, "On fast construction of SAH-based bounding volume hierarchies",
 * 2007). One thread, plain arithmetic: the same tree on every machine.
 *
 * <p>Where no such split exists (all centroids coincide), or where the tree is so deep that it has degenerated, a range is
 * split at the median, so the depth is bounded whatever the scene.
 */
public final class BvhBuilder {
    private static final int MAX_LEAF = 4;

    /** From this depth on, ranges are split at the median: 2^28 primitives then end before {@link Nodes#MAX_DEPTH}. */
    private static final int MEDIAN_DEPTH = Nodes.MAX_DEPTH - 32;

    /** The cost of visiting a node, in units of a primitive's test. */
    private static final double NODE_COST = 2;

    /** A leaf smaller than this share of the reach is too coarse in floats, whose widening is 2^-20 of the reach. */
    private static final double COARSE = 0x1p-14;

    private static final int NO_PARENT = -1;

    /** Cancellation is checked before ranges of at least this number of items: smaller ones take far less than a millisecond. */
    private static final int POLLED = 1024;

    private final ItemBoxes items;
    private final BinnedSplit split;
    private final double[] box = new double[ItemBoxes.BOX];
    private final double widening;
    private float[] boxes;
    private int[] child;
    private int nodes;
    private int leaves;
    private int smallLeaves;

    /**
     * @param poll called regularly; what it throws ends the building
     */
    public BvhBuilder(ItemBoxes items, Runnable poll) {
        int n = items.size();
        if (n >= Nodes.MOST_ITEMS) {
            throw new IllegalArgumentException(
                    n + " primitives are more than a hierarchy can hold: " + (Nodes.MOST_ITEMS - 1));
        }
        this.items = items;
        split = new BinnedSplit(items);
        widening = FloatSlabs.widening(items.reach());
        // Leaves of about two: half as many nodes as items.
        int capacity = n / 2 + n / 16 + 1;
        boxes = new float[Nodes.NODE * capacity];
        child = new int[2 * capacity];
        grow(n, poll);
        boxes = Arrays.copyOf(boxes, Nodes.NODE * nodes);
        child = Arrays.copyOf(child, 2 * nodes);
    }

    /** Makes the nodes in depth-first order, with a stack of ranges (start, end, depth, slot in a parent) instead of recursion. */
    private void grow(int n, Runnable poll) {
        int[] todo = new int[4 * (Nodes.MAX_DEPTH + 1)];
        int top = push(todo, 0, 0, n, 0, NO_PARENT);
        while (top > 0) {
            top -= 4;
            int start = todo[top];
            int end = todo[top + 1];
            int depth = todo[top + 2];
            int slot = todo[top + 3];
            if (end - start >= POLLED) {
                poll.run();
            }
            split.measure(start, end, box);
            int middle = split(start, end, depth);
            if (middle < 0) {
                // The root has two children even if the second is empty.
                int at = slot == NO_PARENT ? 2 * newNode() : slot;
                setLeaf(at, start, end);
                if (slot == NO_PARENT) {
                    set(at + 1, Nodes.EMPTY);
                }
            } else {
                int node = newNode();
                if (slot != NO_PARENT) {
                    set(slot, node);
                }
                top = push(todo, top, middle, end, depth + 1, 2 * node + 1);
                top = push(todo, top, start, middle, depth + 1, 2 * node);
            }
        }
    }

    private static int push(int[] todo, int top, int start, int end, int depth, int slot) {
        todo[top] = start;
        todo[top + 1] = end;
        todo[top + 2] = depth;
        todo[top + 3] = slot;
        return top + 4;
    }

    private int newNode() {
        if (2 * nodes == child.length) {
            int capacity = nodes + nodes / 4 + 1;
            boxes = Arrays.copyOf(boxes, Nodes.NODE * capacity);
            child = Arrays.copyOf(child, 2 * capacity);
        }
        return nodes++;
    }

    private void setLeaf(int slot, int start, int end) {
        set(slot, Nodes.leaf(start, end - start));
        double extent = 0;
        for (int k = 0; k < 3 && start < end; k++) {
            extent = Math.max(extent, box[3 + k] - box[k]);
        }
        leaves++;
        smallLeaves += extent < COARSE * items.reach() ? 1 : 0;
    }

    /** Fills a child's slot: slot 2n + s is side s of node n. */
    private void set(int slot, int link) {
        child[slot] = link;
        int at = Nodes.NODE * (slot / 2) + slot % 2;
        for (int k = 0; k < 3; k++) {
            boolean empty = !(box[k] <= box[3 + k]);
            // The box of an empty child is a point, not infinite: no search may compute with infinities.
            float center = empty ? 0 : (float) (0.5 * box[k] + 0.5 * box[3 + k]);
            double half = empty ? 0 : Math.max(box[3 + k] - center, center - box[k]);
            boxes[at + 2 * k] = center;
            boxes[at + 6 + 2 * k] = FloatSlabs.up(half + widening);
        }
    }

    /** Splits a range and partitions its items; returns the start of the second part, -1 if the range becomes a leaf. */
    private int split(int start, int end, int depth) {
        int n = end - start;
        if (n <= NODE_COST) {
            return -1; // No split is cheaper than testing them.
        }
        if (depth < MEDIAN_DEPTH && split.find(start, end)) {
            double whole = items.area(box, 0);
            if (n <= MAX_LEAF && n * whole <= NODE_COST * whole + split.cost()) {
                return -1;
            }
            return split.partition(start, end);
        }
        if (n <= MAX_LEAF) {
            return -1;
        }
        int middle = (start + end) >>> 1;
        items.select(start, end, middle, split.widestAxis());
        return middle;
    }

    /** Whether boxes of floats are fine enough: more than half of the leaves are large compared to the roundings. */
    public boolean fitsFloats() {
        return items.size() == 0 || FloatSlabs.suits(items.reach()) && 2 * smallLeaves <= leaves;
    }

    public double reach() {
        return items.reach();
    }

    /** By place in the leaves: the index of the item. */
    public int[] order() {
        return items.ids();
    }

    /** The children's boxes, rounded outwards, as {@link FloatSlabs} takes them. */
    public float[] floats() {
        return boxes;
    }

    /** The links to children, two for each node. */
    public int[] child() {
        return child;
    }
}

package enlightenment.world.parts;

import enlightenment.numeric.MedianCut;
import java.util.Arrays;

/**
 * Finds which of many boxes contain a point: a floor has as many boxes as there are objects on it, and each ray that hits it asks. A
 * balanced tree, its nodes as in a heap, its leaves of up to {@link #LEAF} boxes; read only once it is built.
 */
public final class PlaceTree {
    /** The number of boxes in a leaf, which a loop tests as fast. */
    public static final int LEAF = 16;

    /** Numbers of a box: its lower corner, its upper corner. */
    public static final int BOX = 6;

    /** The indices of the boxes, those of a leaf adjacent. */
    private final int[] items;

    /** The box of each node; the children of node i are 2i + 1 and 2i + 2. */
    private final double[] nodes;

    private final int levels;

    /**
     * Makes a tree of boxes.
     *
     * @param boxes six numbers for each
     * @param bounds six numbers: a box that most points will lie in; the tree separates the boxes by their parts within it
     */
    public PlaceTree(double[] boxes, double[] bounds) {
        int n = boxes.length / BOX;
        int l = 0;
        while (n > LEAF << l) {
            l++;
        }
        levels = l;
        items = new int[n];
        Arrays.setAll(items, i -> i);
        nodes = new double[BOX * ((2 << levels) - 1)];
        new Builder(boxes, bounds).build(0, 0, n, levels);
    }

    /** Adds the indices of some boxes in no order, among them all that contain a point. */
    public void candidates(double x, double y, double z, IntList out) {
        candidates(0, 0, items.length, levels, x, y, z, out);
    }

    private void candidates(int node, int from, int to, int below, double x, double y, double z, IntList out) {
        if (!holds(BOX * node, x, y, z)) {
            return;
        }
        if (below == 0) {
            for (int i = from; i < to; i++) {
                out.add(items[i]);
            }
            return;
        }
        int middle = (from + to) >>> 1;
        candidates(2 * node + 1, from, middle, below - 1, x, y, z, out);
        candidates(2 * node + 2, middle, to, below - 1, x, y, z, out);
    }

    private boolean holds(int at, double x, double y, double z) {
        return x >= nodes[at]
                && x <= nodes[at + 3]
                && y >= nodes[at + 1]
                && y <= nodes[at + 4]
                && z >= nodes[at + 2]
                && z <= nodes[at + 5];
    }

    private final class Builder {
        private final double[] boxes;

        /** By axis, the centres of the boxes' parts within the bounds. */
        private final double[][] centers;

        Builder(double[] boxes, double[] bounds) {
            this.boxes = boxes;
            centers = new double[3][items.length];
            for (int i = 0; i < items.length; i++) {
                for (int c = 0; c < 3; c++) {
                    double low = Math.max(boxes[BOX * i + c], bounds[c]);
                    double high = Math.min(boxes[BOX * i + 3 + c], bounds[3 + c]);
                    centers[c][i] = 0.5 * low + 0.5 * high;
                }
            }
        }

        void build(int node, int from, int to, int below) {
            enclose(BOX * node, from, to);
            if (below == 0) {
                return;
            }
            int middle = (from + to) >>> 1;
            double[] along = centers[MedianCut.longestSide(from, to, (k, axis) -> centers[axis][items[k]])];
            MedianCut.select(items, from, to, middle, item -> along[item], count -> {});
            build(2 * node + 1, from, middle, below - 1);
            build(2 * node + 2, middle, to, below - 1);
        }

        private void enclose(int at, int from, int to) {
            for (int c = 0; c < 3; c++) {
                double low = Double.POSITIVE_INFINITY;
                double high = Double.NEGATIVE_INFINITY;
                for (int i = from; i < to; i++) {
                    low = Math.min(low, boxes[BOX * items[i] + c]);
                    high = Math.max(high, boxes[BOX * items[i] + 3 + c]);
                }
                nodes[at + c] = low;
                nodes[at + 3 + c] = high;
            }
        }
    }
}

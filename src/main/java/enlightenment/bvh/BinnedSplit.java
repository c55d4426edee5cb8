package enlightenment.bvh;

/** Finds the split of a range of boxes with the lowest surface area cost between equal bins of centroids, over all three axes. */
final class BinnedSplit {
    private final ItemBoxes items;

    /** The box of the items of the range, and behind it the box of their centroids. */
    private final double[] range = new double[2 * ItemBoxes.BOX];

    /** By axis: bins per length; 0 if the centroids coincide. */
    private final double[] scale = new double[3];

    private final Bins[] bins = {new Bins(), new Bins(), new Bins()};
    private final double[] sweep = new double[ItemBoxes.BOX];
    private int axis;
    private double cost;

    BinnedSplit(ItemBoxes items) {
        this.items = items;
    }

    /** Measures the range start..end−1, for the other methods; box receives the box of its items. */
    void measure(int start, int end, double[] box) {
        items.measure(start, end, range);
        System.arraycopy(range, 0, box, 0, ItemBoxes.BOX);
    }

    /** The extent of the centroids on an axis. */
    private double spread(int a) {
        return range[ItemBoxes.BOX + 3 + a] - range[ItemBoxes.BOX + a];
    }

    /** Searches a split into two parts that are not empty; false if there is none. */
    boolean find(int start, int end) {
        for (int a = 0; a < 3; a++) {
            scale[a] = spread(a) > 0 ? Bins.COUNT / spread(a) : 0;
        }
        fill(start, end);
        cost = Double.POSITIVE_INFINITY;
        for (int a = 0; a < 3; a++) {
            double c = scale[a] > 0 ? bins[a].sweep(items, sweep) : Double.POSITIVE_INFINITY;
            if (c < cost) {
                cost = c;
                axis = a;
            }
        }
        return cost < Double.POSITIVE_INFINITY;
    }

    /** The surface area cost of the split: area times number of items, summed over both parts. */
    double cost() {
        return cost;
    }

    /** The axis with the largest extent of the centroids. */
    int widestAxis() {
        int widest = 0;
        for (int a = 1; a < 3; a++) {
            if (spread(a) > spread(widest)) {
                widest = a;
            }
        }
        return widest;
    }

    /** The bin of a centroid's coordinate; the last one where the quotient overflows. */
    private static int bin(double center, double lowest, double scale) {
        return Math.min(Bins.COUNT - 1, (int) ((center - lowest) * scale));
    }

    private void fill(int start, int end) {
        double[] b = items.numbers();
        Bins onX = bins[0];
        Bins onY = bins[1];
        Bins onZ = bins[2];
        onX.clear();
        onY.clear();
        onZ.clear();
        for (int p = ItemBoxes.BOX * start; p < ItemBoxes.BOX * end; p += ItemBoxes.BOX) {
            double x0 = b[p];
            double y0 = b[p + 1];
            double z0 = b[p + 2];
            double x1 = b[p + 3];
            double y1 = b[p + 4];
            double z1 = b[p + 5];
            onX.add(bin(0.5 * x0 + 0.5 * x1, range[6], scale[0]), x0, y0, z0, x1, y1, z1);
            onY.add(bin(0.5 * y0 + 0.5 * y1, range[7], scale[1]), x0, y0, z0, x1, y1, z1);
            onZ.add(bin(0.5 * z0 + 0.5 * z1, range[8], scale[2]), x0, y0, z0, x1, y1, z1);
        }
    }

    /** Partitions start..end−1 by the split that was found; returns the start of the second part. */
    int partition(int start, int end) {
        double lowest = range[ItemBoxes.BOX + axis];
        int border = bins[axis].border();
        int i = start;
        int j = end - 1;
        while (i <= j) {
            if (bin(items.center(i, axis), lowest, scale[axis]) < border) {
                i++;
            } else {
                items.swap(i, j--);
            }
        }
        return i;
    }
}

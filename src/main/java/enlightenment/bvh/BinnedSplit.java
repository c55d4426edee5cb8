package enlightenment.bvh;

import java.util.Arrays;

/** Finds the split of a range of boxes with the lowest surface area cost between equal bins of centroids, over all three axes. */
final class BinnedSplit {
    private static final int BINS = 16;

    /** Up to this many items are sorted by their bins: sixteen bins on three axes would be mostly empty. */
    private static final int FEW = 8;

    private final ItemBoxes items;
    private final double[] lowest = new double[3];
    private final double[] highest = new double[3];
    private final double[] scale = new double[3];
    private final double[] binBoxes = new double[3 * BINS * 6];
    private final int[] binCounts = new int[3 * BINS];
    private final double[] sweep = new double[6];
    private final double[] rightCost = new double[BINS];

    /** A few items and their bins, and the boxes of the items from each of them on. */
    private final int[] fewItems = new int[FEW];

    private final int[] fewBins = new int[FEW];
    private final double[] fewBoxes = new double[6 * FEW];

    private int axis;
    private int border;
    private double cost;

    BinnedSplit(ItemBoxes items) {
        this.items = items;
    }

    /** Looks for a split of start..end−1 into two parts that are not empty; false if there is none. */
    boolean find(int start, int end) {
        boolean few = end - start <= FEW;
        measure(start, end);
        if (!few) {
            fill(start, end);
        }
        cost = Double.POSITIVE_INFINITY;
        for (int a = 0; a < 3; a++) {
            if (scale[a] > 0) {
                if (few) {
                    sweepFew(a, start, end - start);
                } else {
                    sweep(a, end - start);
                }
            }
        }
        return cost < Double.POSITIVE_INFINITY;
    }

    /** As {@link #sweep}, with the same result: only borders next to an item's bin are looked at, all others split alike or not at all. */
    private void sweepFew(int a, int start, int n) {
        for (int i = 0; i < n; i++) {
            int bin = bin(start + i, a);
            int k = i;
            for (; k > 0 && fewBins[k - 1] > bin; k--) {
                fewBins[k] = fewBins[k - 1];
                fewItems[k] = fewItems[k - 1];
            }
            fewBins[k] = bin;
            fewItems[k] = start + i;
        }
        ItemBoxes.clear(sweep, 0);
        for (int k = n - 1; k > 0; k--) {
            items.add(fewItems[k], sweep, 0);
            System.arraycopy(sweep, 0, fewBoxes, 6 * k, 6);
        }
        ItemBoxes.clear(sweep, 0);
        for (int k = 1; k < n; k++) {
            items.add(fewItems[k - 1], sweep, 0);
            if (fewBins[k - 1] < fewBins[k]) {
                double c = k * items.area(sweep, 0) + (n - k) * items.area(fewBoxes, 6 * k);
                if (c < cost) {
                    cost = c;
                    axis = a;
                    border = fewBins[k - 1] + 1;
                }
            }
        }
    }

    /** The surface area cost of the split: area times number of items, summed over both parts. */
    double cost() {
        return cost;
    }

    /** The axis with the largest extent of the centroids of start..end−1. */
    int widestAxis(int start, int end) {
        measure(start, end);
        int widest = 0;
        for (int a = 1; a < 3; a++) {
            if (highest[a] - lowest[a] > highest[widest] - lowest[widest]) {
                widest = a;
            }
        }
        return widest;
    }

    private void measure(int start, int end) {
        Arrays.fill(lowest, Double.POSITIVE_INFINITY);
        Arrays.fill(highest, Double.NEGATIVE_INFINITY);
        items.encloseCenters(start, end, lowest, highest);
        for (int a = 0; a < 3; a++) {
            double spread = highest[a] - lowest[a];
            scale[a] = spread > 0 ? BINS / spread : 0;
        }
    }

    /** The bin of item i on an axis; the last one where the quotient overflows. */
    private int bin(int i, int a) {
        int k = (int) ((items.center(i, a) - lowest[a]) * scale[a]);
        return k < BINS ? k : BINS - 1;
    }

    private void fill(int start, int end) {
        Arrays.fill(binCounts, 0);
        for (int k = 0; k < 3 * BINS; k++) {
            ItemBoxes.clear(binBoxes, 6 * k);
        }
        for (int i = start; i < end; i++) {
            for (int a = 0; a < 3; a++) {
                if (scale[a] > 0) {
                    int k = BINS * a + bin(i, a);
                    binCounts[k]++;
                    items.add(i, binBoxes, 6 * k);
                }
            }
        }
    }

    private void sweep(int a, int total) {
        int n = 0;
        ItemBoxes.clear(sweep, 0);
        for (int k = BINS - 1; k > 0; k--) {
            n += binCounts[BINS * a + k];
            ItemBoxes.merge(binBoxes, 6 * (BINS * a + k), sweep, 0);
            rightCost[k] = n == 0 ? Double.POSITIVE_INFINITY : n * items.area(sweep, 0);
        }
        n = 0;
        ItemBoxes.clear(sweep, 0);
        for (int k = 1; k < BINS && n < total; k++) {
            n += binCounts[BINS * a + k - 1];
            ItemBoxes.merge(binBoxes, 6 * (BINS * a + k - 1), sweep, 0);
            double c = n == 0 ? Double.POSITIVE_INFINITY : n * items.area(sweep, 0) + rightCost[k];
            if (c < cost) {
                cost = c;
                axis = a;
                border = k;
            }
        }
    }

    /** Partitions start..end−1 by the split that was found; returns where the second part begins. */
    int partition(int start, int end) {
        int i = start;
        int j = end - 1;
        while (i <= j) {
            if (bin(i, axis) < border) {
                i++;
            } else {
                items.swap(i, j--);
            }
        }
        return i;
    }
}

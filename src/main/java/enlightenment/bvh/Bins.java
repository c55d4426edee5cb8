package enlightenment.bvh;

/**
 * Equal bins of centroids on one axis: for each, how many items it has and their box. Empty bins cost nothing: a bin is set by its first item, and
 * a sweep visits the others alone. Two borders with empty bins between them split alike, so the costs are those of all borders.
 */
final class Bins {
    static final int COUNT = 16;

    private final double[] boxes = new double[ItemBoxes.BOX * COUNT];
    private final int[] counts = new int[COUNT];
    private final double[] upperCosts = new double[COUNT];

    /** Bit k is set if bin k has an item. */
    private int used;

    private int border;
    private double cost;

    /** Empties all bins. */
    void clear() {
        used = 0;
    }

    /** Adds an item by its box. */
    void add(int bin, double x0, double y0, double z0, double x1, double y1, double z1) {
        double[] b = boxes;
        int at = ItemBoxes.BOX * bin;
        if ((used >> bin & 1) == 0) {
            used |= 1 << bin;
            counts[bin] = 1;
            ItemBoxes.set(b, at, x0, y0, z0, x1, y1, z1);
            return;
        }
        counts[bin]++;
        if (x0 < b[at]) {
            b[at] = x0;
        }
        if (y0 < b[at + 1]) {
            b[at + 1] = y0;
        }
        if (z0 < b[at + 2]) {
            b[at + 2] = z0;
        }
        if (x1 > b[at + 3]) {
            b[at + 3] = x1;
        }
        if (y1 > b[at + 4]) {
            b[at + 4] = y1;
        }
        if (z1 > b[at + 5]) {
            b[at + 5] = z1;
        }
    }

    /** Finds the border with the lowest surface area cost, the first of equal ones; infinite if all items are in one bin. */
    double sweep(ItemBoxes items, double[] box) {
        ItemBoxes.clear(box, 0);
        int n = 0;
        for (int rest = used; (rest & rest - 1) != 0; ) {
            int k = highest(rest);
            rest ^= 1 << k;
            n += counts[k];
            ItemBoxes.merge(boxes, ItemBoxes.BOX * k, box, 0);
            upperCosts[highest(rest)] = n * items.area(box, 0);
        }
        ItemBoxes.clear(box, 0);
        n = 0;
        cost = Double.POSITIVE_INFINITY;
        for (int rest = used; (rest & rest - 1) != 0; rest &= rest - 1) {
            int k = Integer.numberOfTrailingZeros(rest);
            n += counts[k];
            ItemBoxes.merge(boxes, ItemBoxes.BOX * k, box, 0);
            double c = n * items.area(box, 0) + upperCosts[k];
            if (c < cost) {
                cost = c;
                border = k + 1;
            }
        }
        return cost;
    }

    private static int highest(int bits) {
        return 31 - Integer.numberOfLeadingZeros(bits);
    }

    /** The first bin beyond the border that {@link #sweep} found. */
    int border() {
        return border;
    }
}

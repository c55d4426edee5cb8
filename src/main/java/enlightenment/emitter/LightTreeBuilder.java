package enlightenment.emitter;

import enlightenment.math.Vec3;

/**
 * Builds the nodes of a {@link LightTree} top down, by the surface area orientation heuristic of A. Conty Estevez and C. Kulla, "Importance
 * sampling of many lights with adaptive tree splitting", 2018. A node's lights are a range of one array, which a split partitions in place,
 * stably. A mutable work object, for one tree.
 */
final class LightTreeBuilder {
    private static final int BUCKETS = 12;

    /** Below this depth lights are halved by number, so that the tree cannot degenerate to a list. */
    private static final int DEEPEST = 48;

    /** Cancellation is checked before at least this number of lights are split. */
    private static final int POLLED = 1024;

    private final LightNode[] leaves;
    private final LightNode[] second;
    private final Runnable poll;

    /** By axis and light: the centres of the lights' boxes. */
    private final double[][] centers;

    /** By non-empty bucket, in order: its lights, and its index. */
    private final LightGroup[] groups = new LightGroup[BUCKETS];

    private final int[] bucketOf = new int[BUCKETS];
    private final LightGroup[] byBucket = new LightGroup[BUCKETS];
    private final LightGroup low = new LightGroup();
    private final LightGroup high = new LightGroup();

    /**
     * The cheapest split of the current node: its axis, −1 if there is none; the range of centres on that axis; the last bucket of its
     * first part.
     */
    private int axis;

    private double start;
    private double end;
    private int lastBucket;
    private double least;

    private LightTreeBuilder(LightNode[] leaves, Runnable poll) {
        this.leaves = leaves;
        this.poll = poll;
        second = new LightNode[leaves.length];
        centers = new double[3][leaves.length];
        for (int b = 0; b < BUCKETS; b++) {
            byBucket[b] = new LightGroup();
        }
        for (LightNode n : leaves) {
            Vec3 center = n.box.center();
            centers[0][n.light] = center.x();
            centers[1][n.light] = center.y();
            centers[2][n.light] = center.z();
        }
    }

    /**
     * Builds the tree of these lights.
     *
     * @param leaves by light: its node, at least one; reordered
     * @param poll called regularly; what it throws ends the building
     */
    static LightNode build(LightNode[] leaves, Runnable poll) {
        return new LightTreeBuilder(leaves, poll).tree(0, leaves.length, 0);
    }

    private LightNode tree(int from, int to, int depth) {
        if (to - from == 1) {
            return leaves[from];
        }
        if (to - from >= POLLED) {
            poll.run();
        }
        int middle = depth > DEEPEST ? from : split(from, to);
        if (middle == from || middle == to) {
            middle = from + (to - from) / 2;
        }
        return LightNode.of(tree(from, middle, depth + 1), tree(middle, to, depth + 1));
    }

    /**
     * Partitions the lights by the cheapest split; returns the index of the second part's first light, an end of the range if all centres
     * coincide.
     */
    private int split(int from, int to) {
        double longest = 0;
        double[] lower = new double[3];
        double[] upper = new double[3];
        for (int k = 0; k < 3; k++) {
            findRange(from, to, k, lower, upper);
            longest = Math.max(longest, Math.abs(upper[k] - lower[k]));
        }
        axis = -1;
        least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double extent = upper[k] - lower[k];
            if (extent > 0) {
                group(from, to, k, lower[k], upper[k]);
                weigh(k, lower[k], upper[k], longest / extent);
            }
        }
        return axis < 0 ? from : divide(from, to);
    }

    private void findRange(int from, int to, int k, double[] lower, double[] upper) {
        double[] c = centers[k];
        lower[k] = c[leaves[from].light];
        upper[k] = lower[k];
        for (int i = from + 1; i < to; i++) {
            double v = c[leaves[i].light];
            lower[k] = Math.min(lower[k], v);
            upper[k] = Math.max(upper[k], v);
        }
    }

    /** The bucket of a centre in a range. */
    private static int bucket(double center, double lower, double upper) {
        return Math.min((int) (BUCKETS * ((center - lower) / (upper - lower))), BUCKETS - 1);
    }

    private void group(int from, int to, int k, double lower, double upper) {
        for (LightGroup g : byBucket) {
            g.clear();
        }
        double[] c = centers[k];
        for (int i = from; i < to; i++) {
            LightNode n = leaves[i];
            byBucket[bucket(c[n.light], lower, upper)].add(n);
        }
    }

    /** Computes the cost of splitting after each bucket but the last; after an empty bucket it is that of the bucket before. */
    private void weigh(int k, double lower, double upper, double elongation) {
        int count = 0;
        for (int b = 0; b < BUCKETS; b++) {
            if (!byBucket[b].isEmpty()) {
                bucketOf[count] = b;
                groups[count++] = byBucket[b];
            }
        }
        low.clear();
        for (int g = 0; g + 1 < count; g++) {
            low.add(groups[g]);
            high.clear();
            for (int h = g + 1; h < count; h++) {
                high.add(groups[h]);
            }
            double cost = elongation * (low.cost() + high.cost());
            if (cost < least) {
                least = cost;
                axis = k;
                start = lower;
                end = upper;
                lastBucket = bucketOf[g];
            }
        }
    }

    private int divide(int from, int to) {
        double[] c = centers[axis];
        int first = from;
        int others = 0;
        for (int i = from; i < to; i++) {
            LightNode n = leaves[i];
            if (bucket(c[n.light], start, end) <= lastBucket) {
                leaves[first++] = n;
            } else {
                second[others++] = n;
            }
        }
        System.arraycopy(second, 0, leaves, first, others);
        return first;
    }
}

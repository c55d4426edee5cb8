package enlightenment.accel;

import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/**
 * A bounding volume hierarchy: finds the closest or any intersection of a ray without testing every primitive. Immutable,
 * safe for any number of threads.
 *
 * <p>A binary tree of boxes, built by the surface area heuristic ({@link BvhBuilder}). Nodes lie in depth-first order in
 * flat arrays: the left child of an inner node is the next node, its right child is {@code link}; {@code skip} is the
 * node that follows the whole subtree, so that a traversal in fixed order needs no stack. The answers are those of a
 * loop over all primitives, bit for bit: boxes are tested conservatively ({@link SlabTest}), and {@link Closest} decides
 * what is closer.
 */
public final class Bvh {
    /** The depth of the tree is at most this. */
    static final int MAX_DEPTH = 64;

    private static final int NUMBERS_PER_BOX = 6;

    /** Bounds the rounding of half a box's diagonal. */
    private static final double DIAGONAL_ERROR = Scale.gamma(8);

    private final Primitive[] primitives;
    private final int[] ids;
    private final double[] boxes;
    private final int[] link;
    private final int[] count;
    private final int[] skip;
    private final double reach;

    private Bvh(BvhBuilder builder) {
        primitives = builder.primitives();
        ids = builder.ids();
        boxes = builder.boxes();
        link = builder.link();
        count = builder.count();
        skip = builder.skip();
        double largest = 0;
        for (int i = 0; i < NUMBERS_PER_BOX && i < boxes.length; i++) {
            largest = Math.max(largest, Math.abs(boxes[i]));
        }
        reach = largest;
    }

    /** Builds the hierarchy of these primitives. Ids are indices into the array, which is not kept. */
    public static Bvh build(Primitive[] primitives) {
        return new Bvh(new BvhBuilder(primitives));
    }

    /** The number of nodes: 0 if there is no primitive. */
    public int nodeCount() {
        return count.length;
    }

    /**
     * Finds the closest crossing with t at least {@link Ray#tMin}.
     *
     * @return the id of the primitive, or -1; t is in the state
     */
    public int closest(Ray ray, Closest state) {
        state.reset(Double.MAX_VALUE);
        if (count.length == 0) {
            return state.id();
        }
        SlabTest slabs = state.slabs;
        slabs.set(ray, reach);
        int[] stack = state.stack;
        double[] stackEntry = state.stackEntry;
        int depth = 0;
        int node = slabs.entry(boxes, 0, slabs.limit(state.t())) == Double.POSITIVE_INFINITY ? -1 : 0;
        while (node >= 0) {
            int next = -1;
            if (count[node] > 0) {
                offerLeaf(ray, node, state);
            } else {
                double bound = slabs.limit(state.t());
                int left = node + 1;
                int right = link[node];
                double l = slabs.entry(boxes, NUMBERS_PER_BOX * left, bound);
                double r = slabs.entry(boxes, NUMBERS_PER_BOX * right, bound);
                boolean leftFirst = l <= r;
                double later = leftFirst ? r : l;
                if ((leftFirst ? l : r) < Double.POSITIVE_INFINITY) {
                    next = leftFirst ? left : right;
                    if (later < Double.POSITIVE_INFINITY) {
                        stack[depth] = leftFirst ? right : left;
                        stackEntry[depth++] = later;
                    }
                }
            }
            // A box entered exactly where the best crossing lies may hold one that wins the tie.
            while (next < 0 && depth > 0) {
                depth--;
                if (stackEntry[depth] <= slabs.limit(state.t())) {
                    next = stack[depth];
                }
            }
            node = next;
        }
        return state.id();
    }

    private void offerLeaf(Ray ray, int node, Closest state) {
        int end = link[node] + count[node];
        for (int i = link[node]; i < end; i++) {
            state.offer(ray, primitives[i], ids[i]);
        }
    }

    /** Whether any primitive has a crossing with tMin ≤ t ≤ tMax; stops at the first one found. */
    public boolean occluded(Ray ray, double tMax, BvhQuery query) {
        SlabTest slabs = query.slabs;
        slabs.set(ray, reach);
        double bound = slabs.limit(tMax);
        int node = 0;
        while (node < count.length) {
            if (slabs.entry(boxes, NUMBERS_PER_BOX * node, bound) == Double.POSITIVE_INFINITY) {
                node = skip[node];
            } else if (count[node] == 0) {
                node++;
            } else if (leafBlocks(ray, node, tMax, query)) {
                return true;
            } else {
                node = skip[node];
            }
        }
        return false;
    }

    private boolean leafBlocks(Ray ray, int node, double tMax, BvhQuery query) {
        int end = link[node] + count[node];
        for (int i = link[node]; i < end; i++) {
            if (query.blocks(primitives[i], ids[i], ray, tMax)) {
                return true;
            }
        }
        return false;
    }

    /** Adds the ids of all primitives in leaves whose boxes may intersect a cone; conservative. */
    public void gather(BallCone cone, BvhQuery query) {
        int node = 0;
        while (node < count.length) {
            node = gather(node, misses(node, cone), query);
        }
    }

    /** Sets the list to the ids of all primitives in leaves whose boxes overlap a box. */
    public void overlapping(Bounds box, BvhQuery query) {
        query.clear();
        int node = 0;
        while (node < count.length) {
            node = gather(node, !overlaps(node, box), query);
        }
    }

    /** Adds the ids of a leaf, unless the node is disjoint from the query; returns the next node of the traversal. */
    private int gather(int node, boolean disjoint, BvhQuery query) {
        if (!disjoint && count[node] == 0) {
            return node + 1;
        }
        int end = disjoint ? 0 : link[node] + count[node];
        for (int i = link[node]; i < end; i++) {
            query.add(ids[i]);
        }
        return skip[node];
    }

    private boolean overlaps(int node, Bounds box) {
        int k = NUMBERS_PER_BOX * node;
        return boxes[k] <= box.max().x()
                && box.min().x() <= boxes[k + 3]
                && boxes[k + 1] <= box.max().y()
                && box.min().y() <= boxes[k + 4]
                && boxes[k + 2] <= box.max().z()
                && box.min().z() <= boxes[k + 5];
    }

    private boolean misses(int node, BallCone cone) {
        int k = NUMBERS_PER_BOX * node;
        double hx = (boxes[k + 3] - boxes[k]) / 2;
        double hy = (boxes[k + 4] - boxes[k + 1]) / 2;
        double hz = (boxes[k + 5] - boxes[k + 2]) / 2;
        double radius = Math.sqrt(hx * hx + hy * hy + hz * hz) * (1 + DIAGONAL_ERROR);
        return cone.misses(boxes[k] + hx, boxes[k + 1] + hy, boxes[k + 2] + hz, radius);
    }
}

package enlightenment.accel;

import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;

/**
 * A bounding volume hierarchy: finds what a ray meets without asking every primitive. Immutable, safe for any number of
 * threads.
 *
 * <p>A binary tree of boxes, built by the surface area heuristic ({@link BvhBuilder}). Nodes lie in depth-first order in
 * flat arrays: the left child of an inner node is the next node, its right child is named by {@code link}; {@code skip}
 * is the node that follows the whole subtree, so that a search in fixed order needs no stack. The answers are those of a
 * loop over all primitives, bit for bit: boxes are tested conservatively ({@link SlabTest}), and {@link Closest} decides
 * what is closer.
 */
public final class Bvh {
    /** No node lies deeper. */
    static final int MAX_DEPTH = 64;

    private static final int NUMBERS_PER_BOX = 6;

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
        double greatest = 0;
        for (int i = 0; i < NUMBERS_PER_BOX && i < boxes.length; i++) {
            greatest = Math.max(greatest, Math.abs(boxes[i]));
        }
        reach = greatest;
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
     * Finds the closest crossing of the ray, t &ge; {@link Ray#tMin}; {@code state} then holds its t and id.
     *
     * @return the id of the primitive that is crossed, or -1
     */
    public int closest(Ray ray, Closest state) {
        return closest(ray, Double.MAX_VALUE, state);
    }

    /** As {@link #closest(Ray, Closest)}, for crossings with t &le; limit. */
    public int closest(Ray ray, double limit, Closest state) {
        state.reset(limit);
        if (count.length == 0) {
            return state.id();
        }
        SlabTest slabs = state.slabs;
        slabs.set(ray, reach);
        int[] stack = state.stack;
        double[] stackEntry = state.stackEntry;
        int depth = 0;
        int node = slabs.entry(boxes, 0, slabs.limit(state.t())) < Double.POSITIVE_INFINITY ? 0 : -1;
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
            // A box that begins exactly where the best crossing lies may hold one that wins the tie.
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

    /** Whether anything is crossed with {@link Ray#tMin} &le; t &le; tMax; stops at the first that is found. */
    public boolean occluded(Ray ray, double tMax) {
        SlabTest slabs = new SlabTest();
        slabs.set(ray, reach);
        double bound = slabs.limit(tMax);
        int node = 0;
        while (node < count.length) {
            if (!(slabs.entry(boxes, NUMBERS_PER_BOX * node, bound) < Double.POSITIVE_INFINITY)) {
                node = skip[node];
            } else if (count[node] == 0) {
                node++;
            } else if (leafBlocks(ray, node, tMax)) {
                return true;
            } else {
                node = skip[node];
            }
        }
        return false;
    }

    private boolean leafBlocks(Ray ray, int node, double tMax) {
        int end = link[node] + count[node];
        for (int i = link[node]; i < end; i++) {
            if (primitives[i].nearest(ray, tMax) <= tMax) {
                return true;
            }
        }
        return false;
    }

    /** A region of space that can say of a box whether it may have a point in common with it. */
    @FunctionalInterface
    public interface Region {
        /** False only if no point of the box lies in the region. */
        boolean mayMeet(double minX, double minY, double minZ, double maxX, double maxY, double maxZ);
    }

    /**
     * Collects the primitives that may have a point in a region: those in leaves whose box may meet it. No primitive
     * with a point in the region is left out; some without one may be in.
     *
     * @param ids receives the ids, in no particular order
     * @return how many there are, or -1 if there are more than {@code ids} has room for
     */
    public int gather(Region region, int[] ids) {
        int found = 0;
        int node = 0;
        while (node < count.length) {
            int at = NUMBERS_PER_BOX * node;
            boolean meets = region.mayMeet(
                    boxes[at], boxes[at + 1], boxes[at + 2], boxes[at + 3], boxes[at + 4], boxes[at + 5]);
            if (meets && count[node] == 0) {
                node++;
                continue;
            }
            if (meets) {
                if (found + count[node] > ids.length) {
                    return -1;
                }
                System.arraycopy(this.ids, link[node], ids, found, count[node]);
                found += count[node];
            }
            node = skip[node];
        }
        return found;
    }
}

package enlightenment.accel;

import enlightenment.geometry.Primitive;
import enlightenment.geometry.Ray;
import enlightenment.math.BallCone;
import enlightenment.math.Scale;

/**
 * A bounding volume hierarchy over primitives: a binary tree of boxes in flat arrays, in depth-first order, so that a
 * node's first child is the next node. Immutable, shared by all threads.
 *
 * <p>Boxes are tested conservatively: the interval of a ray in a box is widened by the bound of its roundings, and a box
 * whose entry equals the closest t so far is still looked into. So the hierarchy finds what a loop over all primitives
 * finds, to the last bit.
 */
public final class Bvh {
    /** No leaf is deeper; {@link BvhBuilder} sees to it. */
    static final int MAX_DEPTH = 96;

    /** Roundings of (plane − origin)·(1/direction), with room to spare. */
    private static final double SLAB_ERROR = Scale.gamma(6);

    private final Primitive[] primitives;

    /** Ids of primitives, leaf by leaf. */
    private final int[] order;

    /** Per node: min x, y, z, max x, y, z. */
    private final double[] boxes;

    /** Per node: second child of an inner node; −1 − first index into {@link #order} of a leaf. */
    private final int[] links;

    /** Per node: number of primitives of a leaf, 0 for an inner node. */
    private final byte[] counts;

    Bvh(Primitive[] primitives, int[] order, double[] boxes, int[] links, byte[] counts) {
        this.primitives = primitives;
        this.order = order;
        this.boxes = boxes;
        this.links = links;
        this.counts = counts;
    }

    /** Builds a hierarchy; the array is kept, not copied. */
    public static Bvh build(Primitive[] primitives) {
        return new BvhBuilder(primitives).build();
    }

    /** The number of nodes. */
    public int nodeCount() {
        return links.length;
    }

    /**
     * Finds the closest crossing with t at least {@link Ray#tMin}.
     *
     * @return the id of the primitive, or -1; t is in the state
     */
    public int closest(Ray ray, Closest state) {
        state.reset(Double.MAX_VALUE);
        ray.invert();
        if (links.length == 0) {
            return -1;
        }
        int depth = 0;
        int node = 0;
        if (entry(0, ray, state.t()) == Primitive.MISS) {
            return -1;
        }
        while (true) {
            int count = counts[node];
            if (count > 0) {
                int first = -1 - links[node];
                for (int i = first; i < first + count; i++) {
                    int id = order[i];
                    state.offer(ray, primitives[id], id);
                }
            } else {
                int near = node + 1;
                int far = links[node];
                double a = entry(near, ray, state.t());
                double b = entry(far, ray, state.t());
                if (b < a) {
                    int swap = near;
                    near = far;
                    far = swap;
                    double swapEntry = a;
                    a = b;
                    b = swapEntry;
                }
                if (b != Primitive.MISS) {
                    state.stack[depth] = far;
                    state.entries[depth++] = b;
                }
                if (a != Primitive.MISS) {
                    node = near;
                    continue;
                }
            }
            do {
                if (depth == 0) {
                    return state.id();
                }
                node = state.stack[--depth];
            } while (state.entries[depth] > state.t());
        }
    }

    /** Whether any primitive has a crossing with tMin ≤ t ≤ tMax. Stops at the first. */
    public boolean occluded(Ray ray, double tMax, BvhQuery query) {
        ray.invert();
        if (links.length == 0 || entry(0, ray, tMax) == Primitive.MISS) {
            return false;
        }
        int depth = 0;
        int node = 0;
        while (true) {
            int count = counts[node];
            if (count > 0) {
                int first = -1 - links[node];
                for (int i = first; i < first + count; i++) {
                    if (query.blocks(primitives[order[i]], order[i], ray, tMax)) {
                        return true;
                    }
                }
            } else {
                boolean second = entry(links[node], ray, tMax) != Primitive.MISS;
                if (entry(node + 1, ray, tMax) != Primitive.MISS) {
                    if (second) {
                        query.stack[depth++] = links[node];
                    }
                    node++;
                    continue;
                }
                if (second) {
                    node = links[node];
                    continue;
                }
            }
            if (depth == 0) {
                return false;
            }
            node = query.stack[--depth];
        }
    }

    /** Adds the ids of all primitives in boxes that do not surely keep clear of a cone. */
    public void gather(BallCone cone, BvhQuery query) {
        if (links.length == 0 || misses(0, cone)) {
            return;
        }
        int depth = 0;
        int node = 0;
        while (true) {
            int count = counts[node];
            if (count > 0) {
                int first = -1 - links[node];
                for (int i = first; i < first + count; i++) {
                    query.add(order[i]);
                }
            } else {
                boolean second = !misses(links[node], cone);
                if (!misses(node + 1, cone)) {
                    if (second) {
                        query.stack[depth++] = links[node];
                    }
                    node++;
                    continue;
                }
                if (second) {
                    node = links[node];
                    continue;
                }
            }
            if (depth == 0) {
                return;
            }
            node = query.stack[--depth];
        }
    }

    private boolean misses(int node, BallCone cone) {
        int k = 6 * node;
        double hx = (boxes[k + 3] - boxes[k]) / 2;
        double hy = (boxes[k + 4] - boxes[k + 1]) / 2;
        double hz = (boxes[k + 5] - boxes[k + 2]) / 2;
        double radius = Math.sqrt(hx * hx + hy * hy + hz * hz) * (1 + SLAB_ERROR);
        return cone.misses(boxes[k] + hx, boxes[k + 1] + hy, boxes[k + 2] + hz, radius);
    }

    /** Where the ray comes into a node's box, not before tMin, or MISS if it does not before tMax. NaN bounds nothing. */
    private double entry(int node, Ray ray, double tMax) {
        int k = 6 * node;
        double near = ray.tMin;
        double far = tMax;
        // A zero component gives an infinite inverse and, in a face's plane, NaN, which the comparisons drop.
        double a = (boxes[k] - ray.ox) * ray.invX;
        double b = (boxes[k + 3] - ray.ox) * ray.invX;
        double in = ray.invX > 0 ? a : b;
        double out = ray.invX > 0 ? b : a;
        in -= Math.abs(in) * SLAB_ERROR;
        out += Math.abs(out) * SLAB_ERROR;
        near = in > near ? in : near;
        far = out < far ? out : far;
        a = (boxes[k + 1] - ray.oy) * ray.invY;
        b = (boxes[k + 4] - ray.oy) * ray.invY;
        in = ray.invY > 0 ? a : b;
        out = ray.invY > 0 ? b : a;
        in -= Math.abs(in) * SLAB_ERROR;
        out += Math.abs(out) * SLAB_ERROR;
        near = in > near ? in : near;
        far = out < far ? out : far;
        a = (boxes[k + 2] - ray.oz) * ray.invZ;
        b = (boxes[k + 5] - ray.oz) * ray.invZ;
        in = ray.invZ > 0 ? a : b;
        out = ray.invZ > 0 ? b : a;
        in -= Math.abs(in) * SLAB_ERROR;
        out += Math.abs(out) * SLAB_ERROR;
        near = in > near ? in : near;
        far = out < far ? out : far;
        return near <= far ? near : Primitive.MISS;
    }
}

package enlightenment.accel;

import enlightenment.bvh.BvhBuilder;
import enlightenment.bvh.ItemBoxes;
import enlightenment.bvh.Nodes;
import enlightenment.frame.BallCone;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.primitive.MeshUnion;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import java.util.BitSet;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A bounding volume hierarchy: finds the closest or any intersection of a ray without testing every primitive.
 *
 * <p>A binary tree of boxes, built by the surface area heuristic ({@link BvhBuilder}), in the layout of {@link Nodes}: the boxes of a node's
 * two children lie side by side, twelve numbers in a flat array, so that one visit decides on both. A leaf is a range of {@link Leaves}.
 *
 * <p>Boxes only cull, conservatively; {@link Closest} decides what is closer. So the answers are those of a loop over all
 * primitives, bit for bit. This class holds the searches with boxes of any precision; {@link FloatBvh} has faster ones.
 */
public abstract class Bvh implements Accelerator {
    final int[] child;
    final Leaves leaves;

    /** The largest absolute coordinate of any box. */
    final double reach;

    Bvh(int[] child, Leaves leaves, double reach) {
        this.child = child;
        this.leaves = leaves;
        this.reach = reach;
    }

    /** Builds the hierarchy of these primitives. Ids are indices into the array, which is not kept. */
    public static Bvh build(Primitive[] primitives) {
        return build(primitives, () -> {});
    }

    /**
     * Builds the hierarchy of these primitives, and can be cancelled.
     *
     * @param poll called regularly; what it throws ends the building
     */
    public static Bvh build(Primitive[] primitives, Runnable poll) {
        MeshUnion union = MeshUnion.of(primitives, poll);
        int[] ids = union == null ? count(primitives.length) : without(primitives.length, union);
        return build(primitives, ids, union, poll);
    }

    /** Builds the hierarchy of some of a scene's primitives. */
    static Bvh build(Primitive[] all, int[] ids) {
        return build(all, ids, null, () -> {});
    }

    private static int[] count(int n) {
        return IntStream.range(0, n).toArray();
    }

    private static int[] without(int n, MeshUnion union) {
        BitSet joined = new BitSet();
        for (int k = 0; k < union.size(); k++) {
            joined.set(union.id(k));
        }
        return IntStream.range(0, n).filter(i -> !joined.get(i)).toArray();
    }

    /**
     * @param union meshes that are not among the ids, as one item after them; or null
     */
    private static Bvh build(Primitive[] all, int[] ids, MeshUnion union, Runnable poll) {
        IntFunction<Bounds> boxes = i -> i < ids.length ? all[ids[i]].bounds() : union.bounds();
        BvhBuilder builder = new BvhBuilder(new ItemBoxes(ids.length + (union == null ? 0 : 1), boxes), poll);
        Leaves leaves = new PrimitiveLeaves(all, ids, union, builder.order());
        return builder.fitsFloats()
                ? new FloatBvh(builder, leaves)
                : new DoubleBvh(builder.child(), leaves, builder.reach());
    }

    @Override
    public MeshUnion union() {
        return leaves.union();
    }

    /** The number of nodes, each of two children; at least 1. */
    public final int nodeCount() {
        return child.length / 2;
    }

    /** The t at which the ray enters a child's box (side 0 or 1 of the node), or infinity; see {@link SlabTest#entry}. */
    abstract double entry(SlabTest slabs, int node, int side, double limit);

    /** A coordinate of a child's box, on an axis: the lower, or the upper one. */
    abstract double bound(int node, int side, boolean upper, int axis);

    @Override
    public void search(Ray ray, Closest state) {
        SlabTest slabs = state.slabs;
        slabs.set(ray, reach);
        int[] stack = state.stack;
        double[] entries = state.entries;
        int depth = 0;
        int node = 0;
        while (true) {
            int next = Nodes.EMPTY;
            if (node < 0) {
                leaves.offer(ray, Nodes.first(node), Nodes.end(node), state);
            } else {
                double limit = slabs.limit(state.t());
                double l = entry(slabs, node, 0, limit);
                double r = entry(slabs, node, 1, limit);
                int nearer = l <= r ? 0 : 1;
                double later = nearer == 0 ? r : l;
                if (Math.min(l, r) < Double.POSITIVE_INFINITY) {
                    next = child[2 * node + nearer];
                    if (later < Double.POSITIVE_INFINITY) {
                        stack[depth] = child[2 * node + 1 - nearer];
                        entries[depth++] = later;
                    }
                }
            }
            // A box entered exactly at the closest crossing may contain one that wins the tie.
            while (next == Nodes.EMPTY && depth > 0) {
                depth--;
                if (entries[depth] <= slabs.limit(state.t())) {
                    next = stack[depth];
                }
            }
            if (next == Nodes.EMPTY) {
                return;
            }
            node = next;
        }
    }

    @Override
    public final boolean occluded(Ray ray, double tMax, BvhQuery query) {
        query.startAtRoot();
        return occludedWithin(ray, tMax, query);
    }

    @Override
    public boolean occludedWithin(Ray ray, double tMax, BvhQuery query) {
        SlabTest slabs = query.slabs;
        slabs.set(ray, reach);
        double limit = slabs.limit(tMax);
        int[] stack = query.stack();
        int depth = query.pushFront(ray);
        while (depth > 0) {
            int node = stack[--depth];
            if (node < 0) {
                if (leaves.block(ray, Nodes.first(node), Nodes.end(node), tMax, query)) {
                    return true;
                }
                continue;
            }
            for (int side = 0; side < 2; side++) {
                if (entry(slabs, node, side, limit) < Double.POSITIVE_INFINITY) {
                    stack[depth++] = child[2 * node + side];
                }
            }
        }
        return false;
    }

    /** Sets no front: every ray starts at the root. */
    @Override
    public int narrow(BallCone cone, ConeJudge judge, int rays, BvhQuery query) {
        query.startAtRoot();
        return 1;
    }

    /**
     * Whether a primitive blocks every segment from the cone's apex to its ball, by the judge's verdict. Searches along the cone's axis
     * only: a primitive that blocks every segment blocks that one.
     */
    final boolean blocksAll(BallCone cone, ConeJudge judge, BvhQuery query) {
        SlabTest slabs = query.slabs;
        slabs.set(query.axis.set(cone.x, cone.y, cone.z, cone.wx, cone.wy, cone.wz, 0), reach);
        double limit = slabs.limit(cone.distance);
        int[] stack = query.stack();
        int depth = 1;
        stack[0] = 0;
        while (depth > 0) {
            int node = stack[--depth];
            if (node < 0) {
                if (leaves.blocksAll(cone, Nodes.first(node), Nodes.end(node), judge, query)) {
                    return true;
                }
                continue;
            }
            for (int side = 0; side < 2; side++) {
                if (entry(slabs, node, side, limit) < Double.POSITIVE_INFINITY) {
                    stack[depth++] = child[2 * node + side];
                }
            }
        }
        return false;
    }

    /** Adds the ids in leaves whose boxes overlap a box. */
    @Override
    public final void overlapping(Bounds box, BvhQuery query) {
        int[] stack = query.stack();
        int depth = 1;
        stack[0] = 0;
        while (depth > 0) {
            int node = stack[--depth];
            if (node < 0) {
                leaves.collect(box, Nodes.first(node), Nodes.end(node), query);
                continue;
            }
            for (int side = 0; side < 2; side++) {
                if (overlaps(node, side, box)) {
                    stack[depth++] = child[2 * node + side];
                }
            }
        }
    }

    private boolean overlaps(int node, int side, Bounds box) {
        for (int axis = 0; axis < 3; axis++) {
            if (bound(node, side, false, axis) > box.max().component(axis)
                    || bound(node, side, true, axis) < box.min().component(axis)) {
                return false;
            }
        }
        return true;
    }

    @Override
    public final Bounds bounds() {
        return new Bounds(corner(false), corner(true));
    }

    /** The box of a child: slot 2n + s is side s of node n. */
    final Bounds box(int slot) {
        int n = slot / 2;
        int side = slot % 2;
        return new Bounds(
                new Vec3(bound(n, side, false, 0), bound(n, side, false, 1), bound(n, side, false, 2)),
                new Vec3(bound(n, side, true, 0), bound(n, side, true, 1), bound(n, side, true, 2)));
    }

    private Vec3 corner(boolean upper) {
        double[] c = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double l = bound(0, 0, upper, axis);
            double r = bound(0, 1, upper, axis);
            c[axis] = upper ? Math.max(l, r) : Math.min(l, r);
        }
        return new Vec3(c[0], c[1], c[2]);
    }

    /**
     * The children's boxes as unions of the leaves' boxes, nothing rounded: by node the left one's lower and upper corner, the right one's.
     */
    final double[] exactBoxes() {
        double[] boxes = new double[Nodes.NODE * nodeCount()];
        // Children come after their parents.
        for (int node = nodeCount() - 1; node >= 0; node--) {
            for (int side = 0; side < 2; side++) {
                setExact(boxes, Nodes.NODE * node + ItemBoxes.BOX * side, child[2 * node + side]);
            }
        }
        return boxes;
    }

    private void setExact(double[] boxes, int at, int link) {
        ItemBoxes.clear(boxes, at);
        if (link >= 0) {
            ItemBoxes.merge(boxes, Nodes.NODE * link, boxes, at);
            ItemBoxes.merge(boxes, Nodes.NODE * link + ItemBoxes.BOX, boxes, at);
            return;
        }
        for (int place = Nodes.first(link); place < Nodes.end(link); place++) {
            ItemBoxes.merge(leaves.bounds(place), boxes, at);
        }
    }
}

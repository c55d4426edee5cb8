package enlightenment.mesh.tree;

import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.Nodes;
import enlightenment.mesh.TriangleMesh;
import enlightenment.numeric.EdgeFunctions;

/**
 * A ray in the coordinates of a mesh, and the closest triangle that it meets. A mutable work object, one per thread.
 *
 * <p>A ray that leaves a triangle never meets that again, and its neighbours where the surface rises beside it and the ray turns there
 * ({@link Departure}): no offset is needed.
 */
public final class MeshRay {
    /** The t of no crossing. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** The triangle of a ray that starts on none. */
    public static final int NONE = -1;

    private final FloatSlabs slabs = new FloatSlabs();
    private final int[] stack = new int[Nodes.MAX_DEPTH];
    private final int[] entries = new int[Nodes.MAX_DEPTH];

    private final TriangleTest test = new TriangleTest();
    private final double[] weights = new double[2];
    private TriangleMesh mesh;
    private TriangleTree tree;

    /** The t of the closest crossing, {@link #MISS} if there is none. */
    public double t;

    /** Its triangle. */
    public int triangle;

    /** 1 if the ray meets the triangle from its outside, −1 from its inside. */
    public int side;

    /** The weights of the triangle's second and third corner in the crossing, 0..1; valid after {@link #complete}. */
    public double weightB;

    public double weightC;

    /** A ray to be {@link #set} before use. */
    public MeshRay() {}

    /** Sets the ray, which starts on no triangle; the direction may have any length. */
    public MeshRay set(
            TriangleMesh of, double x, double y, double z, double dirX, double dirY, double dirZ, double from) {
        mesh = of;
        test.set(of, x, y, z, dirX, dirY, dirZ, from);
        return this;
    }

    /**
     * Lets the ray start on a triangle.
     *
     * @param from the triangle
     * @param travels the side of it that the ray travels on: 1 outside, −1 inside
     * @param error bounds how far each coordinate of the origin may be off
     */
    public void startOn(int from, int travels, double error) {
        test.startOn(from, travels, error);
    }

    /** Leaves out one more triangle, on which the ray ends; {@link #NONE} for none. */
    public void leaveOut(int other) {
        test.leftOut = other;
    }

    /** Finds the closest crossing with t in from..tMax; whether there is one. */
    public boolean closest(double tMax) {
        return search(tMax, false);
    }

    /** Whether there is any crossing with t in from..tMax. */
    public boolean isBlocked(double tMax) {
        return search(tMax, true);
    }

    /** Whether any of these triangles has a crossing with t in from..tMax. */
    public boolean isBlockedBy(ShaftTriangles some, double tMax) {
        for (int k = 0; k < some.size(); k++) {
            if (test.test(some.get(k)) <= tMax) {
                return true;
            }
        }
        return false;
    }

    private boolean search(double tMax, boolean any) {
        t = MISS;
        tree = TriangleTree.of(mesh);
        double entry = entry(tMax);
        if (!(entry <= tMax)) {
            return false;
        }
        // In the tree's unit, with a direction whose largest component is in [1, 2), from where the ray enters the
        // mesh's box.
        double[] o = test.o;
        double[] d = test.d;
        double directions = test.scale;
        double unit = tree.unit;
        double qx = d[0] * directions;
        double qy = d[1] * directions;
        double qz = d[2] * directions;
        boolean suits = slabs.set(
                Math.fma(entry, d[0], o[0]) * unit,
                Math.fma(entry, d[1], o[1]) * unit,
                Math.fma(entry, d[2], o[2]) * unit,
                qx,
                qy,
                qz,
                qx * qx + qy * qy + qz * qz,
                0,
                tree.reach);
        return suits && follow(tMax, entry, unit / directions, any);
    }

    private boolean follow(double tMax, double entry, double scale, boolean any) {
        float[] boxes = tree.boxes;
        int[] child = tree.child;
        double best = tMax;
        int limit = FloatSlabs.limit((best - entry) * scale);
        int depth = 1;
        stack[0] = 0;
        entries[0] = 0;
        while (depth > 0) {
            if (entries[--depth] > limit) {
                continue;
            }
            int node = stack[depth];
            while (node >= 0) {
                int l = slabs.entry(boxes, Nodes.NODE * node, limit);
                int r = slabs.entry(boxes, Nodes.NODE * node + 1, limit);
                int nearer = l <= r ? 0 : 1;
                int link = 2 * node;
                node = child[link + nearer];
                if (Math.max(l, r) < FloatSlabs.MISS) {
                    entries[depth] = Math.max(l, r);
                    stack[depth++] = child[link + 1 - nearer];
                } else if (Math.min(l, r) == FloatSlabs.MISS) {
                    node = Nodes.EMPTY;
                }
            }
            if (testLeaf(Nodes.first(node), Nodes.end(node), best)) {
                if (any) {
                    return true;
                }
                best = t;
                limit = FloatSlabs.limit((best - entry) * scale);
            }
        }
        return t != MISS;
    }

    /** Where the ray enters the mesh's box, at least from, a little early; infinite if it misses it. */
    private double entry(double tMax) {
        double[] o = test.o;
        double off = test.tolerance();
        double from = test.tMin;
        double to = tMax;
        for (int axis = 0; axis < 3; axis++) {
            double low = tree.low[axis] - o[axis];
            double high = tree.high[axis] - o[axis];
            double slack = EdgeFunctions.ERROR * (Math.abs(o[axis]) + tree.largest) + off;
            double v = test.d[axis];
            if (v == 0) {
                if (low > slack || high < -slack) {
                    return MISS;
                }
                continue;
            }
            double inverse = test.inverse[axis];
            double widened = slack * Math.abs(inverse);
            double first = Math.min(low * inverse, high * inverse) - widened;
            double last = Math.max(low * inverse, high * inverse) + widened;
            from = first > from ? first : from;
            to = last < to ? last : to;
        }
        return from <= to ? from : MISS;
    }

    /** Tests the triangles of a leaf; whether one is closer than what was known. */
    private boolean testLeaf(int first, int end, double limit) {
        boolean found = false;
        double best = limit;
        for (int i = first; i < end; i++) {
            int candidate = tree.order[i];
            double s = test.test(candidate);
            if (s < best || s == best && wins(candidate)) {
                best = s;
                t = s;
                triangle = candidate;
                side = test.side;
                found = true;
            }
        }
        return found;
    }

    /** At equal t what leaves comes before what enters, then the lower number wins; a crossing at the limit itself counts. */
    private boolean wins(int candidate) {
        return t == MISS || (test.side == side ? candidate < triangle : test.side < side);
    }

    /** Finds the weights of the corners where the ray's line crosses a triangle that {@link #closest} found. */
    public void complete(int found) {
        triangle = found;
        test.weigh(found, weights);
        side = test.side;
        weightB = weights[0];
        weightC = weights[1];
    }
}

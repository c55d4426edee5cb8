package enlightenment.mesh;

import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.Nodes;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A ray in the coordinates of a mesh, and the closest triangle that it meets. A mutable work object, one per thread.
 *
 * <p>Triangles are tested by edge functions of sheared vertices, whose signs are exact for the rounded vertices (Woop, Benthin and Wald,
 * "Watertight ray/triangle intersection", JCGT 2013): triangles that share edges leave no gap.
 *
 * <p>A ray that leaves a triangle never meets that again. A neighbour whose plane the origin lies in, up to the origin's rounding, is met
 * where the surface is concave there and the ray turns to the neighbour, and nowhere else: no offset is needed.
 */
public final class MeshRay {
    /** The t of no crossing. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** The triangle of a ray that starts on none. */
    public static final int NONE = -1;

    /** Bounds the roundings of a sheared coordinate relative to the vertices' distance, and of edge functions to its square. */
    private static final double ERROR = Scale.gamma(64);

    private final FloatSlabs slabs = new FloatSlabs();
    private final int[] stack = new int[Nodes.MAX_DEPTH];
    private final int[] entries = new int[Nodes.MAX_DEPTH];

    /** Origin and direction, by axis. */
    private final double[] o = new double[3];

    private final double[] d = new double[3];
    private double tMin;

    private int kx;
    private int ky;
    private int kz;
    private double ox;
    private double oy;
    private double oz;
    private double shearX;
    private double shearY;
    private double dz;
    private double inverseZ;

    private TriangleTree tree;
    private float[] floats;
    private double[] doubles;
    private int[] indices;

    private int start;
    private int startSide;
    private int leftOut;
    private double tolerance;

    /** The triangle that is being tested, relative to the origin and with the axes turned. */
    private double ax;

    private double ay;
    private double az;
    private double bx;
    private double by;
    private double bz;
    private double cx;
    private double cy;
    private double cz;
    private double e0;
    private double e1;
    private double e2;

    /** Three coordinates of each corner of the triangle that the ray starts on, relative to the origin and with the axes turned. */
    private final double[] startCorners = new double[9];

    private boolean hasStart;

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
            TriangleTree hierarchy, double x, double y, double z, double dirX, double dirY, double dirZ, double from) {
        tree = hierarchy;
        TriangleMesh mesh = hierarchy.mesh;
        floats = mesh.floatPositions();
        doubles = mesh.doublePositions();
        indices = mesh.indices();
        o[0] = x;
        o[1] = y;
        o[2] = z;
        d[0] = dirX;
        d[1] = dirY;
        d[2] = dirZ;
        tMin = from;
        start = NONE;
        hasStart = false;
        leftOut = NONE;
        double sx = Math.abs(dirX);
        double sy = Math.abs(dirY);
        double sz = Math.abs(dirZ);
        kz = sx > sy ? (sx > sz ? 0 : 2) : (sy > sz ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        ox = o[kx];
        oy = o[ky];
        oz = o[kz];
        dz = d[kz];
        inverseZ = 1 / dz;
        shearX = d[kx] * inverseZ;
        shearY = d[ky] * inverseZ;
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
        start = from;
        startSide = travels;
        tolerance = error;
        hasStart = true;
        load(3 * indices[3 * from], 3 * indices[3 * from + 1], 3 * indices[3 * from + 2]);
        startCorners[0] = ax;
        startCorners[1] = ay;
        startCorners[2] = az;
        startCorners[3] = bx;
        startCorners[4] = by;
        startCorners[5] = bz;
        startCorners[6] = cx;
        startCorners[7] = cy;
        startCorners[8] = cz;
    }

    /** Leaves out one more triangle, on which the ray ends; {@link #NONE} for none. */
    public void leaveOut(int other) {
        leftOut = other;
    }

    /** Finds the closest crossing with t in from..tMax; whether there is one. */
    public boolean closest(double tMax) {
        return search(tMax, false);
    }

    /** Whether there is any crossing with t in from..tMax. */
    public boolean isBlocked(double tMax) {
        return search(tMax, true);
    }

    private boolean search(double tMax, boolean any) {
        t = MISS;
        double entry = entry(tMax);
        if (!(entry <= tMax)) {
            return false;
        }
        // In the tree's unit, with a direction whose largest component is in [1, 2), from where the ray enters the
        // mesh's box.
        double directions = 1 / Math.scalb(1.0, Math.getExponent(dz));
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
        double from = tMin;
        double to = tMax;
        for (int axis = 0; axis < 3; axis++) {
            double low = tree.low[axis] - o[axis];
            double high = tree.high[axis] - o[axis];
            double slack = ERROR * (Math.abs(o[axis]) + tree.largest);
            double v = d[axis];
            if (v == 0) {
                if (low > slack || high < -slack) {
                    return MISS;
                }
                continue;
            }
            double inverse = 1 / v;
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
            if (candidate == start || candidate == leftOut || !covers(candidate)) {
                continue;
            }
            double s = distance();
            if (s < best || s == best && wins(candidate)) {
                best = s;
                t = s;
                triangle = candidate;
                side = sideOfArea();
                found = true;
            }
        }
        return found;
    }

    /** At equal t what leaves comes before what enters, then the lower number wins; a crossing at the limit itself counts. */
    private boolean wins(int candidate) {
        if (t == MISS) {
            return true;
        }
        int own = sideOfArea();
        return own == side ? candidate < triangle : own < side;
    }

    /** The side of the triangle that the ray meets: the area of its projection is the normal times the direction, over dz. */
    private int sideOfArea() {
        return (e0 + e1 + e2) * dz < 0 ? 1 : -1;
    }

    /** Whether the ray's line meets a triangle; loads it. */
    private boolean covers(int candidate) {
        load(3 * indices[3 * candidate], 3 * indices[3 * candidate + 1], 3 * indices[3 * candidate + 2]);
        double px = Math.fma(-shearX, az, ax);
        double py = Math.fma(-shearY, az, ay);
        double qx = Math.fma(-shearX, bz, bx);
        double qy = Math.fma(-shearY, bz, by);
        double rx = Math.fma(-shearX, cz, cx);
        double ry = Math.fma(-shearY, cz, cy);
        e0 = Products.difference(px, qy, py, qx);
        e1 = Products.difference(qx, ry, qy, rx);
        e2 = Products.difference(rx, py, ry, px);
        boolean anyNegative = e0 < 0 || e1 < 0 || e2 < 0;
        boolean anyPositive = e0 > 0 || e1 > 0 || e2 > 0;
        return anyNegative != anyPositive;
    }

    private void load(int a, int b, int c) {
        if (doubles == null) {
            float[] p = floats;
            ax = p[a + kx] - ox;
            ay = p[a + ky] - oy;
            az = p[a + kz] - oz;
            bx = p[b + kx] - ox;
            by = p[b + ky] - oy;
            bz = p[b + kz] - oz;
            cx = p[c + kx] - ox;
            cy = p[c + ky] - oy;
            cz = p[c + kz] - oz;
        } else {
            double[] p = doubles;
            ax = p[a + kx] - ox;
            ay = p[a + ky] - oy;
            az = p[a + kz] - oz;
            bx = p[b + kx] - ox;
            by = p[b + ky] - oy;
            bz = p[b + kz] - oz;
            cx = p[c + kx] - ox;
            cy = p[c + ky] - oy;
            cz = p[c + kz] - oz;
        }
    }

    /**
     * The t at which the ray meets the loaded triangle, which it covers: between those of its corners, weighted by the edge functions, with
     * which it agrees however flatly the ray meets it. {@link #MISS} if it does not count.
     */
    private double distance() {
        double ta = az * inverseZ;
        double tb = bz * inverseZ;
        double tc = cz * inverseZ;
        double lo = Math.min(ta, Math.min(tb, tc));
        double hi = Math.max(ta, Math.max(tb, tc));
        double between = (e1 * ta + e2 * tb + e0 * tc) / (e0 + e1 + e2);
        between = between < lo ? lo : between > hi ? hi : between;
        if (hasStart && touchesStart() && isInPlane()) {
            return isConcave() && sideOfArea() == startSide ? tMin : MISS;
        }
        return between >= tMin ? between : MISS;
    }

    /** Whether the loaded triangle has a corner where the one that the ray starts on has one. */
    private boolean touchesStart() {
        double[] s = startCorners;
        for (int k = 0; k < 9; k += 3) {
            double x = s[k];
            if (x == ax && s[k + 1] == ay && s[k + 2] == az
                    || x == bx && s[k + 1] == by && s[k + 2] == bz
                    || x == cx && s[k + 1] == cy && s[k + 2] == cz) {
                return true;
            }
        }
        return false;
    }

    /** Whether the origin lies in the plane of the loaded triangle, as far as it is known. */
    private boolean isInPlane() {
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double vx = cx - ax;
        double vy = cy - ay;
        double vz = cz - az;
        double nx = Products.difference(uy, vz, uz, vy);
        double ny = Products.difference(uz, vx, ux, vz);
        double nz = Products.difference(ux, vy, uy, vx);
        double height = Products.accurateDot(nx, ny, nz, ax, ay, az);
        double far = Math.max(Math.abs(ax), Math.max(Math.abs(ay), Math.abs(az)));
        return Math.abs(height) <= (Math.abs(nx) + Math.abs(ny) + Math.abs(nz)) * (tolerance + ERROR * far);
    }

    /** Whether the farthest corner of the loaded triangle is on the side of the start triangle's plane that the ray travels on. */
    private boolean isConcave() {
        double[] s = startCorners;
        double ux = s[3] - s[0];
        double uy = s[4] - s[1];
        double uz = s[5] - s[2];
        double vx = s[6] - s[0];
        double vy = s[7] - s[1];
        double vz = s[8] - s[2];
        double nx = Products.difference(uy, vz, uz, vy);
        double ny = Products.difference(uz, vx, ux, vz);
        double nz = Products.difference(ux, vy, uy, vx);
        double a = Products.accurateDot(nx, ny, nz, ax - s[0], ay - s[1], az - s[2]);
        double b = Products.accurateDot(nx, ny, nz, bx - s[0], by - s[1], bz - s[2]);
        double c = Products.accurateDot(nx, ny, nz, cx - s[0], cy - s[1], cz - s[2]);
        double farthest = Math.abs(b) > Math.abs(a) ? b : a;
        farthest = Math.abs(c) > Math.abs(farthest) ? c : farthest;
        return farthest * startSide > 0;
    }

    /** Finds the weights of the corners where the ray's line crosses a triangle that {@link #closest} found. */
    public void complete(int found) {
        triangle = found;
        covers(found);
        side = sideOfArea();
        double sum = e0 + e1 + e2;
        weightB = sum == 0 ? 0 : clamped(e2 / sum);
        weightC = sum == 0 ? 0 : clamped(e0 / sum);
    }

    private static double clamped(double weight) {
        return weight > 0 ? Math.min(weight, 1) : 0;
    }
}

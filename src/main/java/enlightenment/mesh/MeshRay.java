package enlightenment.mesh;

import enlightenment.bvh.FloatSlabs;
import enlightenment.bvh.Nodes;
import enlightenment.frame.Bounds;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A ray in the coordinates of a mesh, and the closest triangle that it meets. A mutable work object, one per thread.
 *
 * <p>Triangles are tested by edge functions of sheared vertices, whose signs are exact for the rounded vertices (Woop, Benthin and Wald,
 * "Watertight ray/triangle intersection", JCGT 2013): triangles that share edges leave no gap.
 *
 * <p>A ray that leaves a triangle never meets that again. Whether it meets a triangle that touches that one, where the origin's rounding is in
 * doubt, follows from the corners of both: see {@link Departure}. No offset is needed.
 */
public final class MeshRay {
    /** The t of no crossing. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** The triangle of a ray that starts on none. */
    public static final int NONE = -1;

    /** Bounds the roundings of a sheared coordinate relative to the vertices' distance, and of edge functions to its square. */
    private static final double ERROR = Scale.gamma(64);

    /** An edge function is in doubt up to this many times a vertex' distance and its error. */
    private static final double NEAR = 8;

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

    private TriangleTree tree;
    private float[] floats;
    private double[] doubles;
    private int[] indices;

    private int start;
    private int leftOut;
    private final Departure departure = new Departure();

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
    private double nx;
    private double ny;
    private double nz;

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
        shearX = d[kx] / dz;
        shearY = d[ky] / dz;
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
        departure.set(tree.mesh, from, travels, o, error);
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
        int lengths = -tree.exponent;
        int directions = -Scale.exponent(Math.max(Math.abs(d[0]), Math.max(Math.abs(d[1]), Math.abs(d[2]))));
        double px = scaled(Math.fma(entry, d[0], o[0]), lengths);
        double py = scaled(Math.fma(entry, d[1], o[1]), lengths);
        double pz = scaled(Math.fma(entry, d[2], o[2]), lengths);
        double qx = scaled(d[0], directions);
        double qy = scaled(d[1], directions);
        double qz = scaled(d[2], directions);
        double qq = qx * qx + qy * qy + qz * qz;
        if (!slabs.set(px, py, pz, qx, qy, qz, qq, 0, tree.reach)) {
            return false;
        }
        double scale = Math.scalb(1.0, lengths - directions);
        return follow(tMax, entry, scale, any);
    }

    private static double scaled(double v, int k) {
        return v * Math.scalb(1.0, k);
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
        Bounds box = tree.bounds;
        double off = start == NONE ? 0 : departure.tolerance;
        double from = tMin;
        double to = tMax;
        for (int axis = 0; axis < 3; axis++) {
            double low = box.min().component(axis) - o[axis];
            double high = box.max().component(axis) - o[axis];
            double slack = ERROR * (Math.max(Math.abs(low), Math.abs(high)) + tree.largest) + off;
            if (d[axis] == 0) {
                if (low > slack || high < -slack) {
                    return MISS;
                }
                continue;
            }
            double first = ((d[axis] > 0 ? low : -high) - slack) / Math.abs(d[axis]);
            double last = ((d[axis] > 0 ? high : -low) + slack) / Math.abs(d[axis]);
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
            if (candidate == start || candidate == leftOut) {
                continue;
            }
            boolean covered = covers(candidate);
            double s = start != NONE ? leaving(candidate, covered) : covered ? distance() : MISS;
            if (s < best || s == best && wins(candidate)) {
                best = s;
                t = s;
                triangle = candidate;
                side = towards() < 0 ? 1 : -1;
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
        int own = towards() < 0 ? 1 : -1;
        return own == side ? candidate < triangle : own < side;
    }

    /** The triangle's normal times the direction, with axes turned. */
    private double towards() {
        return Products.dot(nx, ny, nz, d[kx], d[ky], dz);
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

    /** Sets the normal of the loaded triangle; returns the height of its plane above the origin, times the normal's length. */
    private double plane() {
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double vx = cx - ax;
        double vy = cy - ay;
        double vz = cz - az;
        nx = Products.difference(uy, vz, uz, vy);
        ny = Products.difference(uz, vx, ux, vz);
        nz = Products.difference(ux, vy, uy, vx);
        return Products.accurateDot(nx, ny, nz, ax, ay, az);
    }

    /** The t at which the ray meets the loaded triangle, which it covers; {@link #MISS} if that does not count. */
    private double distance() {
        double height = plane();
        return settle(height / Products.accurateDot(nx, ny, nz, d[kx], d[ky], dz));
    }

    /** {@link #distance} of a triangle where the ray starts on another one of the mesh. */
    private double leaving(int candidate, boolean covered) {
        if (departure.corner >= 0) {
            int k = departure.cornerAt(candidate);
            if (k >= 0) {
                return inFan(candidate, k) ? tMin : MISS;
            }
        }
        double m = Math.max(size(ax, ay, az), Math.max(size(bx, by, bz), size(cx, cy, cz)));
        double near = departure.tolerance + ERROR * m;
        if (!covered && !(Math.min(Math.abs(e0), Math.min(Math.abs(e1), Math.abs(e2))) <= NEAR * near * m)) {
            return MISS;
        }
        int edge = departure.sharedEdge(candidate);
        if (edge < 0 && !covered || edge == Departure.ALL) {
            return MISS;
        }
        double height = plane();
        double plane = height / Products.accurateDot(nx, ny, nz, d[kx], d[ky], dz);
        if (edge >= 0) {
            return meets(candidate, edge) ? afterStart(plane, covered) : MISS;
        }
        double edges = size(bx - ax, by - ay, bz - az) + size(cx - ax, cy - ay, cz - az);
        double n = Math.abs(nx) + Math.abs(ny) + Math.abs(nz);
        boolean isAtStart = Math.abs(height) <= n * near + ERROR * m * edges * size(ax, ay, az);
        return isAtStart && departure.isInPlane(candidate) ? MISS : settle(plane);
    }

    /** Whether a ray that leaves the start triangle meets one that shares an edge with it. */
    private boolean meets(int candidate, int edge) {
        double towards = towards();
        if (!departure.isRaised(candidate) || !(towards * departure.sideOf(candidate) < 0)) {
            return false;
        }
        double sign = Math.signum(towards) * Math.signum(dz);
        boolean within0 = edge == 0 || sign * e0 >= 0;
        boolean within1 = edge == 1 || sign * e1 >= 0;
        boolean within2 = edge == 2 || sign * e2 >= 0;
        return within0 && within1 && within2;
    }

    /** The t of a crossing that is known to be there: not before the start, and not beyond the triangle. */
    private double afterStart(double plane, boolean covered) {
        double settled = covered ? settle(plane) : plane;
        double hi = Math.max(az / dz, Math.max(bz / dz, cz / dz));
        return settled == MISS ? tMin : Math.max(tMin, Math.min(settled, hi));
    }

    /** Whether a ray from the start triangle's centroid meets the cone that a triangle is seen as from its corner k. */
    private boolean inFan(int candidate, int k) {
        plane();
        double towards = towards();
        double gx = departure.centroid(kx);
        double gy = departure.centroid(ky);
        double gz = departure.centroid(kz);
        TriangleMesh mesh = tree.mesh;
        int v = mesh.vertex(candidate, k);
        int next = mesh.vertex(candidate, (k + 1) % 3);
        int last = mesh.vertex(candidate, (k + 2) % 3);
        double vx = mesh.coordinate(v, kx) - gx;
        double vy = mesh.coordinate(v, ky) - gy;
        double vz = mesh.coordinate(v, kz) - gz;
        double height = Products.accurateDot(nx, ny, nz, vx, vy, vz);
        if (!(height * towards > 0)) {
            return false;
        }
        double px = Math.fma(-shearX, vz, vx);
        double py = Math.fma(-shearY, vz, vy);
        double nextZ = mesh.coordinate(next, kz) - gz;
        double qx = Math.fma(-shearX, nextZ, mesh.coordinate(next, kx) - gx);
        double qy = Math.fma(-shearY, nextZ, mesh.coordinate(next, ky) - gy);
        double lastZ = mesh.coordinate(last, kz) - gz;
        double rx = Math.fma(-shearX, lastZ, mesh.coordinate(last, kx) - gx);
        double ry = Math.fma(-shearY, lastZ, mesh.coordinate(last, ky) - gy);
        double sign = Math.signum(towards) * Math.signum(dz);
        return sign * Products.difference(px, qy, py, qx) >= 0 && sign * Products.difference(rx, py, ry, px) >= 0;
    }

    /** Makes the distance to the plane agree with the edge functions, which are rounded otherwise where the ray is almost in the plane. */
    private double settle(double plane) {
        double ta = az / dz;
        double tb = bz / dz;
        double tc = cz / dz;
        double lo = Math.min(ta, Math.min(tb, tc));
        double hi = Math.max(ta, Math.max(tb, tc));
        double m = Math.max(size(ax, ay, az), Math.max(size(bx, by, bz), size(cx, cy, cz)));
        double edge = Math.min(Math.abs(e0), Math.min(Math.abs(e1), Math.abs(e2)));
        boolean central = edge > ERROR * m * m;
        if (central && (plane >= lo && plane <= hi || plane < tMin && lo < tMin)) {
            return plane >= tMin ? plane : MISS;
        }
        double between = (e1 * ta + e2 * tb + e0 * tc) / (e0 + e1 + e2);
        between = between < lo ? lo : between > hi ? hi : between;
        boolean agree = Math.abs(plane - between) * Math.abs(dz) <= ERROR * m;
        double settled = agree ? plane : between;
        return settled >= tMin ? settled : MISS;
    }

    private static double size(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** Finds the weights of the corners where the ray's line crosses a triangle that {@link #closest} found. */
    public void complete(int found) {
        triangle = found;
        covers(found);
        plane();
        side = towards() < 0 ? 1 : -1;
        double sum = e0 + e1 + e2;
        weightB = sum == 0 ? 0 : clamped(e2 / sum);
        weightC = sum == 0 ? 0 : clamped(e0 / sum);
    }

    private static double clamped(double weight) {
        return weight > 0 ? Math.min(weight, 1) : 0;
    }
}

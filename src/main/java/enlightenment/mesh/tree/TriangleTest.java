package enlightenment.mesh.tree;

import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.data.MeshData;
import enlightenment.numeric.EdgeFunctions;
import enlightenment.numeric.Products;

/**
 * One ray against one triangle of a mesh after the other, by edge functions of sheared vertices, whose signs are exact for the rounded vertices
 * (Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2013): triangles that share edges leave no gap. A mutable work object.
 */
final class TriangleTest {
    /** How many times its error an edge function may be away from 0 for a neighbour that the ray may meet beyond the shared edge. */
    private static final double NEAR = 4;

    /** Origin and direction, by axis. */
    final double[] o = new double[3];

    final double[] d = new double[3];

    /** By axis, 1 over the direction. */
    final double[] inverse = new double[3];

    /** The power of two that brings the direction's largest component into [1, 2). */
    double scale;

    double tMin;

    /** Axes turned so that the third one is that of the direction's largest component, dz. */
    private int kx;

    private int ky;
    private int kz;
    private double ox;
    private double oy;
    private double oz;
    private double shearX;
    private double shearY;
    double dz;
    private double inverseZ;

    private TriangleMesh mesh;

    /** The largest coordinate of the mesh. */
    private double largest;

    private float[] floats;
    private double[] doubles;
    private int[] indices;

    /** The triangle that the ray starts on, and another one that is left out; {@link MeshRay#NONE} for none. */
    int start;

    int leftOut;

    /** An edge function that is larger tells for certain that the ray passes on its side of the edge, where it leaves the start triangle. */
    private double near;

    private final Departure departure = new Departure();

    /** Three coordinates of each corner of the start triangle, relative to the origin and with the axes turned. */
    private final double[] startCorners = new double[9];

    /** The triangle that is being tested, likewise. */
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

    /** The side that the last triangle was met from: 1 outside, −1 inside. */
    int side;

    void set(TriangleMesh of, double x, double y, double z, double dirX, double dirY, double dirZ, double from) {
        mesh = of;
        largest = of.maxAbs();
        MeshData data = mesh.data();
        floats = data.vertices.floats;
        doubles = data.vertices.doubles;
        indices = data.indices;
        o[0] = x;
        o[1] = y;
        o[2] = z;
        tMin = from;
        start = MeshRay.NONE;
        leftOut = MeshRay.NONE;
        // Meshes that are not turned see a ray in the same direction one after the other.
        if (!(d[0] == dirX && d[1] == dirY && d[2] == dirZ)) {
            direct(dirX, dirY, dirZ);
        }
        ox = o[kx];
        oy = o[ky];
        oz = o[kz];
    }

    private void direct(double dirX, double dirY, double dirZ) {
        d[0] = dirX;
        d[1] = dirY;
        d[2] = dirZ;
        for (int axis = 0; axis < 3; axis++) {
            inverse[axis] = 1 / d[axis];
        }
        double sx = Math.abs(dirX);
        double sy = Math.abs(dirY);
        double sz = Math.abs(dirZ);
        kz = sx > sy ? (sx > sz ? 0 : 2) : (sy > sz ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        dz = d[kz];
        inverseZ = inverse[kz];
        scale = 1 / Math.scalb(1.0, Math.getExponent(dz));
        shearX = d[kx] * inverseZ;
        shearY = d[ky] * inverseZ;
    }

    /** See {@link MeshRay#startOn}. */
    void startOn(int from, int travels, double error) {
        start = from;
        departure.set(mesh, from, travels, largest, error);
        load(from);
        double[] s = startCorners;
        s[0] = ax;
        s[1] = ay;
        s[2] = az;
        s[3] = bx;
        s[4] = by;
        s[5] = bz;
        s[6] = cx;
        s[7] = cy;
        s[8] = cz;
        departure.findCorner(s);
        double far = 2 * (largest + size(ox, oy, oz));
        near = NEAR * (departure.tolerance + EdgeFunctions.ERROR * far) * far;
    }

    /** Bounds how far each coordinate of the origin is off. */
    double tolerance() {
        return start == MeshRay.NONE ? 0 : departure.tolerance;
    }

    /** The t at which the ray meets a triangle; {@link MeshRay#MISS} if it does not, or that does not count. */
    double test(int candidate) {
        if (candidate == start || candidate == leftOut) {
            return MeshRay.MISS;
        }
        boolean covered = covers(candidate);
        if (start != MeshRay.NONE && (covered || isNear()) && touchesStart()) {
            return leaving(candidate, covered);
        }
        return covered ? distance(candidate) : MeshRay.MISS;
    }

    /** Whether the ray could meet the loaded triangle, which it does not cover, if that were a neighbour of the start triangle. */
    private boolean isNear() {
        return departure.corner >= 0 || Math.abs(e0) <= near || Math.abs(e1) <= near || Math.abs(e2) <= near;
    }

    /** Whether the ray's line meets a triangle; loads it. */
    private boolean covers(int candidate) {
        load(candidate);
        double px = Math.fma(-shearX, az, ax);
        double py = Math.fma(-shearY, az, ay);
        double qx = Math.fma(-shearX, bz, bx);
        double qy = Math.fma(-shearY, bz, by);
        double rx = Math.fma(-shearX, cz, cx);
        double ry = Math.fma(-shearY, cz, cy);
        e0 = Products.difference(px, qy, py, qx);
        e1 = Products.difference(qx, ry, qy, rx);
        e2 = Products.difference(rx, py, ry, px);
        return EdgeFunctions.cover(e0, e1, e2);
    }

    private void load(int triangle) {
        int a = 3 * indices[3 * triangle];
        int b = 3 * indices[3 * triangle + 1];
        int c = 3 * indices[3 * triangle + 2];
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

    /**
     * The t at which the ray meets the loaded triangle, which it covers: between those of its corners, weighted by the edge functions, with
     * which it agrees however flatly the ray meets it.
     */
    private double distance(int candidate) {
        // The area of the projection is the normal times the direction, over dz.
        double area = e0 + e1 + e2;
        side = area * dz < 0 ? 1 : -1;
        double t = between(area);
        if (!(t >= tMin) || start != MeshRay.NONE && mayBeInPlane(t * area * dz) && isInPlane(candidate)) {
            return MeshRay.MISS;
        }
        return t;
    }

    private double between(double area) {
        double ta = az * inverseZ;
        double tb = bz * inverseZ;
        double tc = cz * inverseZ;
        double lo = Math.min(ta, Math.min(tb, tc));
        double hi = Math.max(ta, Math.max(tb, tc));
        double t = (e1 * ta + e2 * tb + e0 * tc) / area;
        return t < lo ? lo : t > hi ? hi : t;
    }

    /** Whether the origin may lie in the loaded triangle's plane, which is so high above it, times the normal's length. */
    private boolean mayBeInPlane(double height) {
        double edges = size(bx - ax, by - ay, bz - az) * size(cx - ax, cy - ay, cz - az);
        double near = departure.tolerance + EdgeFunctions.ERROR * size(ax, ay, az);
        // A component of the normal is at most twice the product of the edges' largest components.
        return Math.abs(height) <= 2 * 3 * 2 * edges * near;
    }

    /** Whether the origin lies in the loaded triangle's plane, as far as it is known, and so does the triangle that the ray starts on. */
    private boolean isInPlane(int candidate) {
        double height = plane();
        double m = reach();
        double near = departure.tolerance + EdgeFunctions.ERROR * m;
        double edges = size(bx - ax, by - ay, bz - az) + size(cx - ax, cy - ay, cz - az);
        double n = Math.abs(nx) + Math.abs(ny) + Math.abs(nz);
        boolean isAtStart = Math.abs(height) <= n * near + EdgeFunctions.ERROR * m * edges * size(ax, ay, az);
        if (!isAtStart) {
            return false;
        }
        departure.prepare();
        return departure.isInPlane(candidate);
    }

    private double reach() {
        return Math.max(size(ax, ay, az), Math.max(size(bx, by, bz), size(cx, cy, cz)));
    }

    private static double size(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
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

    /** The triangle's normal times the direction; {@link #plane} has been called. */
    private double towards() {
        return Products.accurateDot(nx, ny, nz, d[kx], d[ky], dz);
    }

    /** The t of a triangle that touches the one that the ray starts on. */
    private double leaving(int candidate, boolean covered) {
        departure.prepare();
        if (departure.corner >= 0) {
            int k = departure.cornerAt(candidate);
            if (k >= 0) {
                return inFan(candidate, k) ? tMin : MeshRay.MISS;
            }
        }
        int edge = departure.sharedEdge(candidate);
        if (edge == Departure.ALL) {
            return MeshRay.MISS;
        }
        if (edge < 0) {
            return covered ? distance(candidate) : MeshRay.MISS;
        }
        double m = reach();
        double near = departure.tolerance + EdgeFunctions.ERROR * m;
        if (!covered && !(Math.min(Math.abs(e0), Math.min(Math.abs(e1), Math.abs(e2))) <= NEAR * near * m)) {
            return MeshRay.MISS;
        }
        double height = plane();
        double towards = towards();
        side = towards < 0 ? 1 : -1;
        return meets(candidate, edge, towards) ? afterStart(height / towards, covered) : MeshRay.MISS;
    }

    /** Whether a ray that leaves the start triangle meets one that shares an edge with it. */
    private boolean meets(int candidate, int edge, double towards) {
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
        double t = covered ? between(e0 + e1 + e2) : plane;
        double hi = Math.max(az * inverseZ, Math.max(bz * inverseZ, cz * inverseZ));
        return Math.max(tMin, Math.min(t, hi));
    }

    /** Whether a ray from the start triangle's centroid meets the cone that a triangle is seen as from its corner k. */
    private boolean inFan(int candidate, int k) {
        plane();
        double towards = towards();
        side = towards < 0 ? 1 : -1;
        double gx = departure.centroid(kx);
        double gy = departure.centroid(ky);
        double gz = departure.centroid(kz);
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

    /** Finds the weights of the second and the third corner where the ray's line crosses a triangle, and its side. */
    void weigh(int triangle, double[] weights) {
        covers(triangle);
        plane();
        side = towards() < 0 ? 1 : -1;
        double sum = e0 + e1 + e2;
        weights[0] = sum == 0 ? 0 : clamped(e2 / sum);
        weights[1] = sum == 0 ? 0 : clamped(e0 / sum);
    }

    private static double clamped(double weight) {
        return weight > 0 ? Math.min(weight, 1) : 0;
    }
}

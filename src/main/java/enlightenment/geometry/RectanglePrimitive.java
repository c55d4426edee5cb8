package enlightenment.geometry;

import enlightenment.math.Bounds;
import enlightenment.math.Products;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;

/**
 * A parallelogram with corners a (lower left), b (upper left), c (upper right), d (lower right).
 *
 * <p>Inside or outside is decided by the signs of four edge functions of the corners, sheared so that the ray is the z
 * axis (Woop, Benthin and Wald 2013) and evaluated by Kahan's difference of products, so the signs are exact for the
 * sheared corners: two rectangles that share an edge leave no gap. Where the rectangle is parallel to the axes, an
 * interval test with an error bound decides first, and the edge functions only inside that bound.
 */
public final class RectanglePrimitive extends Primitive {
    /** Bounds the roundings of the quick test and of the edge functions together, with room to spare. */
    private static final double QUICK_TEST_ERROR = Scale.gamma(64);

    private final Vec3 a;
    private final Vec3 b;
    private final Vec3 c;
    private final Vec3 d;
    private final Vec3 n;
    private final double nn;

    /** The axis that the rectangle is perpendicular to, or -1 if it is not parallel to two axes. */
    private final int axis;

    /** The other two axes. */
    private final int axis1;

    private final int axis2;
    private final double plane;
    private final double lo1;
    private final double hi1;
    private final double lo2;
    private final double hi2;
    private final double edgeMagnitude;

    RectanglePrimitive(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        super(
                Math.max(Math.max(a.maxAbs(), b.maxAbs()), Math.max(c.maxAbs(), d.maxAbs())),
                Math.min(b.minus(a).maxAbs(), d.minus(a).maxAbs()));
        this.a = a;
        this.b = b;
        this.c = c;
        this.d = d;
        Vec3 up = b.minus(a);
        Vec3 right = d.minus(a);
        n = up.cross(right);
        nn = n.lengthSquared();
        axis = alignedAxis(up, right);
        axis1 = axis == 0 ? 1 : 0;
        axis2 = axis == 2 ? 1 : 2;
        Bounds box = Bounds.of(a, b, c, d);
        plane = axis < 0 ? 0 : a.component(axis);
        lo1 = box.min().component(axis1);
        hi1 = box.max().component(axis1);
        lo2 = box.min().component(axis2);
        hi2 = box.max().component(axis2);
        edgeMagnitude = box.maxAbs();
    }

    private int alignedAxis(Vec3 up, Vec3 right) {
        for (int k = 0; k < 3; k++) {
            boolean flat = a.component(k) == b.component(k)
                    && a.component(k) == c.component(k)
                    && a.component(k) == d.component(k);
            int i = k == 0 ? 1 : 0;
            int j = k == 2 ? 1 : 2;
            boolean straight = (up.component(i) == 0 && right.component(j) == 0)
                    || (up.component(j) == 0 && right.component(i) == 0);
            boolean closed = Bounds.of(a, b, d).equals(Bounds.of(a, b, c, d));
            if (flat && straight && closed) {
                return k;
            }
        }
        return -1;
    }

    /** The corners: lower left, upper left, upper right, lower right. */
    public Vec3[] corners() {
        return new Vec3[] {a, b, c, d};
    }

    /** The unnormalised normal; a viewer whom it points to sees the corners clockwise in the paper's axes. */
    public Vec3 planeNormal() {
        return n;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this) {
            return MISS;
        }
        double t = axis < 0 ? planeDistance(ray) : (plane - ray.o(axis)) / ray.d(axis);
        if (!(t >= ray.tMin && t <= tMax)) {
            return MISS;
        }
        return (axis < 0 ? insideEdges(ray) : insideAligned(ray, t)) ? t : MISS;
    }

    private double planeDistance(Ray ray) {
        double denominator = Products.accurateDot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz);
        return Products.accurateDot(n.x(), n.y(), n.z(), a.x() - ray.ox, a.y() - ray.oy, a.z() - ray.oz) / denominator;
    }

    private boolean insideAligned(Ray ray, double t) {
        double o1 = ray.o(axis1);
        double d1 = ray.d(axis1);
        double o2 = ray.o(axis2);
        double d2 = ray.d(axis2);
        double p1 = Math.fma(t, d1, o1);
        double p2 = Math.fma(t, d2, o2);
        double e1 = QUICK_TEST_ERROR * (Math.abs(t * d1) + Math.abs(o1) + edgeMagnitude);
        double e2 = QUICK_TEST_ERROR * (Math.abs(t * d2) + Math.abs(o2) + edgeMagnitude);
        if (p1 < lo1 - e1 || p1 > hi1 + e1 || p2 < lo2 - e2 || p2 > hi2 + e2) {
            return false;
        }
        if (p1 > lo1 + e1 && p1 < hi1 - e1 && p2 > lo2 + e2 && p2 < hi2 - e2) {
            return true;
        }
        return insideEdges(ray);
    }

    /** Whether the ray's line passes within the closed outline: all edge functions of one sign. */
    private boolean insideEdges(Ray ray) {
        ray.shear();
        double ax = Watertight.x(ray, a);
        double ay = Watertight.y(ray, a);
        double bx = Watertight.x(ray, b);
        double by = Watertight.y(ray, b);
        double cx = Watertight.x(ray, c);
        double cy = Watertight.y(ray, c);
        double px = Watertight.x(ray, d);
        double py = Watertight.y(ray, d);
        double e0 = Products.difference(ax, by, ay, bx);
        double e1 = Products.difference(bx, cy, by, cx);
        double e2 = Products.difference(cx, py, cy, px);
        double e3 = Products.difference(px, ay, py, ax);
        boolean anyNegative = e0 < 0 || e1 < 0 || e2 < 0 || e3 < 0;
        boolean anyPositive = e0 > 0 || e1 > 0 || e2 > 0 || e3 > 0;
        return anyNegative != anyPositive;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        double x = Math.fma(t, ray.dx, ray.ox);
        double y = Math.fma(t, ray.dy, ray.oy);
        double z = Math.fma(t, ray.dz, ray.oz);
        if (axis < 0) {
            double off = Products.accurateDot(n.x(), n.y(), n.z(), x - a.x(), y - a.y(), z - a.z()) / nn;
            hit.setPoint(Math.fma(-off, n.x(), x), Math.fma(-off, n.y(), y), Math.fma(-off, n.z(), z));
            hit.setNormal(n.x(), n.y(), n.z());
        } else {
            // The coordinate of a named plane is assigned, not computed, so that coincident planes tie exactly.
            hit.setPoint(axis == 0 ? plane : x, axis == 1 ? plane : y, axis == 2 ? plane : z);
            hit.nx = axis == 0 ? Math.signum(n.x()) : 0;
            hit.ny = axis == 1 ? Math.signum(n.y()) : 0;
            hit.nz = axis == 2 ? Math.signum(n.z()) : 0;
        }
        hit.side = Products.dot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz) < 0 ? Ray.OUTSIDE : Ray.INSIDE;
        hit.face = 0;
    }

    @Override
    public void textureCoordinates(Hit hit) {
        Vec3 up = b.minus(a);
        Vec3 right = d.minus(a);
        Vec3 p = hit.point().minus(a);
        // p = s·right + r·up, solved by cross products with the normal.
        hit.u = Watertight.clamp01(up.cross(p).dot(n) / nn);
        hit.v = Watertight.clamp01(1 - p.cross(right).dot(n) / nn);
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(a, b, c, d);
    }

    @Override
    public boolean isSolid() {
        return false;
    }

    @Override
    public boolean contains(double x, double y, double z) {
        return false;
    }

    @Override
    Primitive scaledBy(int k) {
        return new RectanglePrimitive(a.scaledBy(k), b.scaledBy(k), c.scaledBy(k), d.scaledBy(k));
    }

    @Override
    public double[] parameters() {
        return concat(a, b, c, d);
    }
}

package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.EdgeFunctions;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A parallelogram with corners a (lower left), b (upper left), c (upper right), d (lower right).
 *
 * <p>It is met where one of the triangles abc and acd is, decided by the signs of sheared edge functions
 * ({@link Watertight}): two rectangles that share an edge leave no gap. The corners are those of a parallelogram only up
 * to rounding, and its outline, seen almost edge-on, may intersect itself; two triangles still cover the area that it bounds.
 * If the rectangle is parallel to the axes, an interval test with an error bound decides first, and the edge functions
 * only within that bound.
 */
public final class RectanglePrimitive extends Primitive {
    /** A generous bound of the roundings of the quick test and of the edge functions together. */
    private static final double QUICK_TEST_ERROR = Scale.gamma(64);

    private final Vec3 a;
    private final Vec3 b;
    private final Vec3 c;
    private final Vec3 d;
    private final Plane plane;

    /** The axis that the rectangle is perpendicular to if its edges are parallel to the others, or -1. */
    private final int axis;

    private final double lo1;
    private final double hi1;
    private final double lo2;
    private final double hi2;
    private final double edgeMagnitude;

    RectanglePrimitive(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        this(null, a, b, c, d);
    }

    /** @param degenerate the exact unit normal if rounding made the corners collinear, else null */
    RectanglePrimitive(Vec3 degenerate, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        super(
                Math.max(Math.max(a.maxAbs(), b.maxAbs()), Math.max(c.maxAbs(), d.maxAbs())),
                Math.min(b.minus(a).maxAbs(), d.minus(a).maxAbs()));
        this.a = a;
        this.b = b;
        this.c = c;
        this.d = d;
        Vec3 up = b.minus(a);
        Vec3 right = d.minus(a);
        plane = new Plane(degenerate, a, up, right, b, c, d);
        axis = alignedAxis(up, right);
        int axis1 = axis == 0 ? 1 : 0;
        int axis2 = axis == 2 ? 1 : 2;
        Bounds box = bounds();
        lo1 = box.min().component(axis1);
        hi1 = box.max().component(axis1);
        lo2 = box.min().component(axis2);
        hi2 = box.max().component(axis2);
        edgeMagnitude = box.maxAbs();
    }

    /** The axis that the rectangle is perpendicular to if its edges are parallel to the other two, so that it is its own box; else -1. */
    public int alignedAxis() {
        return axis;
    }

    private int alignedAxis(Vec3 up, Vec3 right) {
        int k = plane.axis;
        if (k < 0) {
            return -1;
        }
        int i = k == 0 ? 1 : 0;
        int j = k == 2 ? 1 : 2;
        boolean straight =
                (up.component(i) == 0 && right.component(j) == 0) || (up.component(j) == 0 && right.component(i) == 0);
        boolean closed = c.component(i) == (up.component(i) == 0 ? d : b).component(i)
                && c.component(j) == (up.component(j) == 0 ? d : b).component(j);
        return straight && closed ? k : -1;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this) {
            return MISS;
        }
        if (axis == 2) {
            return nearestAligned(ray, ray.ox, ray.dx, ray.oy, ray.dy, plane.coordinate - ray.oz, ray.dz, tMax);
        }
        if (axis == 1) {
            return nearestAligned(ray, ray.ox, ray.dx, ray.oz, ray.dz, plane.coordinate - ray.oy, ray.dy, tMax);
        }
        if (axis == 0) {
            return nearestAligned(ray, ray.oy, ray.dy, ray.oz, ray.dz, plane.coordinate - ray.ox, ray.dx, tMax);
        }
        return nearestByEdges(ray, plane.distance(ray), tMax);
    }

    /** Decides by the crossing with the plane, unless rounding could put it on the other side of an edge. */
    private double nearestAligned(
            Ray ray, double o1, double d1, double o2, double d2, double gap, double across, double tMax) {
        double slope = Math.abs(across);
        if (slope == 0) {
            return MISS;
        }
        double width = QUICK_TEST_ERROR * (Math.abs(ray.ox) + Math.abs(ray.oy) + Math.abs(ray.oz) + edgeMagnitude);
        // Crossings far behind or too far ahead are rejected before the division; closer to the limits the following
        // test decides as usual.
        double ahead = across > 0 ? gap : -gap;
        double behind = ray.tMin < 0 ? ray.tMin * slope * (1 + QUICK_TEST_ERROR) : 0;
        if (ahead < behind - 2 * width || ahead > Math.fma(tMax, slope * (1 + QUICK_TEST_ERROR), 2 * width)) {
            return MISS;
        }
        double t = gap / across;
        double early = max(ray.tMin - t, t - tMax);
        if (early * slope > width) {
            return MISS;
        }
        double p1 = Math.fma(t, d1, o1);
        double p2 = Math.fma(t, d2, o2);
        double outside = max(max(lo1 - p1, p1 - hi1), max(lo2 - p2, p2 - hi2));
        // An error of this width in the ray displaces the point in the plane by the slant times as much.
        double slanted = width * (slope + Math.abs(d1) + Math.abs(d2));
        if (outside * slope > slanted) {
            return MISS;
        }
        if (outside * slope < -slanted) {
            return early <= 0 ? t : MISS;
        }
        return nearestByEdges(ray, t, tMax);
    }

    /** The larger of two numbers; unlike {@link Math#max} it does not order zeros and may drop NaN, at half the cost. */
    private static double max(double a, double b) {
        return a > b ? a : b;
    }

    private double nearestByEdges(Ray ray, double planeDistance, double tMax) {
        ray.shear();
        double ax = Watertight.x(ray, a);
        double ay = Watertight.y(ray, a);
        double bx = Watertight.x(ray, b);
        double by = Watertight.y(ray, b);
        double cx = Watertight.x(ray, c);
        double cy = Watertight.y(ray, c);
        double px = Watertight.x(ray, d);
        double py = Watertight.y(ray, d);
        double ab = Products.difference(ax, by, ay, bx);
        double bc = Products.difference(bx, cy, by, cx);
        double cd = Products.difference(cx, py, cy, px);
        double da = Products.difference(px, ay, py, ax);
        double ac = Products.difference(ax, cy, ay, cx);
        double t;
        if (EdgeFunctions.cover(ab, bc, -ac)) {
            t = Watertight.settle(ray, planeDistance, a, b, c, ab, bc, -ac);
        } else if (EdgeFunctions.cover(ac, cd, da)) {
            t = Watertight.settle(ray, planeDistance, a, c, d, ac, cd, da);
        } else {
            return MISS;
        }
        return t <= tMax ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        plane.complete(ray, t, hit);
    }

    @Override
    public void textureCoordinates(Hit hit) {
        plane.textureCoordinates(hit);
    }

    @Override
    public boolean textureDirections(Hit hit) {
        hit.setTextureDirections(d.minus(a), b.minus(a));
        return true;
    }

    @Override
    public boolean hasTextureDirections() {
        return true;
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(a, b, c, d);
    }

    @Override
    public boolean isFlat() {
        return true;
    }

    @Override
    public SupportSurface support(int face) {
        return SupportSurface.Plane.of(plane.n, a, b, c, d);
    }

    @Override
    public FlatForm flatForm() {
        return FlatForm.of(FlatForm.Kind.RECTANGLE, plane.flatForm(), concat(a, b, c, d), new double[] {
            axis, lo1, hi1, lo2, hi2, edgeMagnitude
        });
    }

    @Override
    Primitive scaledBy(int k) {
        return new RectanglePrimitive(
                plane.degenerateNormal(), a.scaledBy(k), b.scaledBy(k), c.scaledBy(k), d.scaledBy(k));
    }

    @Override
    public double[] parameters() {
        return concat(a, b, c, d);
    }
}

package enlightenment.geometry;

import enlightenment.math.Bounds;
import enlightenment.math.Products;
import enlightenment.math.Vec3;

/**
 * A triangle, tested by sheared edge functions whose signs are exact for the sheared vertices (Woop, Benthin and Wald,
 * "Watertight ray/triangle intersection", JCGT 2013, with Kahan's difference of products): triangles that share edges and
 * vertices leave no gap.
 */
public final class TrianglePrimitive extends Primitive {
    private final Vec3 a;
    private final Vec3 b;
    private final Vec3 c;
    private final Vec3 n;
    private final double nn;

    TrianglePrimitive(Vec3 a, Vec3 b, Vec3 c) {
        super(
                Math.max(a.maxAbs(), Math.max(b.maxAbs(), c.maxAbs())),
                Math.min(
                        b.minus(a).maxAbs(),
                        Math.min(c.minus(a).maxAbs(), c.minus(b).maxAbs())));
        this.a = a;
        this.b = b;
        this.c = c;
        n = b.minus(a).cross(c.minus(a));
        nn = n.lengthSquared();
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this || !isInside(ray)) {
            return MISS;
        }
        double denominator = Products.accurateDot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz);
        double t =
                Products.accurateDot(n.x(), n.y(), n.z(), a.x() - ray.ox, a.y() - ray.oy, a.z() - ray.oz) / denominator;
        return t >= ray.tMin && t <= tMax ? t : MISS;
    }

    private boolean isInside(Ray ray) {
        ray.shear();
        double ax = Watertight.x(ray, a);
        double ay = Watertight.y(ray, a);
        double bx = Watertight.x(ray, b);
        double by = Watertight.y(ray, b);
        double cx = Watertight.x(ray, c);
        double cy = Watertight.y(ray, c);
        double e0 = Products.difference(ax, by, ay, bx);
        double e1 = Products.difference(bx, cy, by, cx);
        double e2 = Products.difference(cx, ay, cy, ax);
        boolean anyNegative = e0 < 0 || e1 < 0 || e2 < 0;
        boolean anyPositive = e0 > 0 || e1 > 0 || e2 > 0;
        return anyNegative != anyPositive;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        double x = Math.fma(t, ray.dx, ray.ox);
        double y = Math.fma(t, ray.dy, ray.oy);
        double z = Math.fma(t, ray.dz, ray.oz);
        double off = Products.accurateDot(n.x(), n.y(), n.z(), x - a.x(), y - a.y(), z - a.z()) / nn;
        hit.setPoint(Math.fma(-off, n.x(), x), Math.fma(-off, n.y(), y), Math.fma(-off, n.z(), z));
        hit.setNormal(n.x(), n.y(), n.z());
        hit.side = Products.dot(n.x(), n.y(), n.z(), ray.dx, ray.dy, ray.dz) < 0 ? Ray.OUTSIDE : Ray.INSIDE;
        hit.face = 0;
    }

    /** The first vertex is the texture's lower left corner, the second its upper left, the third its lower right. */
    @Override
    public void textureCoordinates(Hit hit) {
        Vec3 up = b.minus(a);
        Vec3 right = c.minus(a);
        Vec3 p = hit.point().minus(a);
        hit.u = Watertight.clamp01(up.cross(p).dot(n) / nn);
        hit.v = Watertight.clamp01(1 - p.cross(right).dot(n) / nn);
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(a, b, c);
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
        return new TrianglePrimitive(a.scaledBy(k), b.scaledBy(k), c.scaledBy(k));
    }

    @Override
    public double[] parameters() {
        return concat(a, b, c);
    }
}

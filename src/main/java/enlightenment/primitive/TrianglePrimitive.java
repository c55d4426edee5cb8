package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.EdgeFunctions;
import enlightenment.numeric.Products;

/**
 * A triangle, tested by edge functions whose signs are exact for the sheared vertices ({@link Watertight}): triangles
 * that share edges and vertices leave no gap.
 *
 * <p>The normal that points to {@link Ray#OUTSIDE} is (b − a) × (c − a).
 */
public final class TrianglePrimitive extends Primitive {
    private final Vec3 a;
    private final Vec3 b;
    private final Vec3 c;
    private final Plane plane;

    /** The texture coordinates of the corners; null if the triangle is a half of the whole texture. */
    private final CornerUv uv;

    TrianglePrimitive(Vec3 a, Vec3 b, Vec3 c) {
        this(null, a, b, c, null);
    }

    /** @param degenerate the exact unit normal if rounding made the corners collinear, else null */
    TrianglePrimitive(Vec3 degenerate, Vec3 a, Vec3 b, Vec3 c) {
        this(degenerate, a, b, c, null);
    }

    /** @param uv the texture coordinates of the corners; null for those that {@link #textureCoordinates} states */
    TrianglePrimitive(Vec3 degenerate, Vec3 a, Vec3 b, Vec3 c, CornerUv uv) {
        super(
                Math.max(a.maxAbs(), Math.max(b.maxAbs(), c.maxAbs())),
                Math.min(
                        b.minus(a).maxAbs(),
                        Math.min(c.minus(a).maxAbs(), c.minus(b).maxAbs())));
        this.a = a;
        this.b = b;
        this.c = c;
        this.uv = uv;
        plane = new Plane(degenerate, a, b.minus(a), c.minus(a), b, c);
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this) {
            return MISS;
        }
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
        if (!EdgeFunctions.cover(e0, e1, e2)) {
            return MISS;
        }
        double t = Watertight.settle(ray, plane.distance(ray), a, b, c, e0, e1, e2);
        return t <= tMax ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        plane.complete(ray, t, hit);
    }

    /**
     * The interpolated coordinates of the corners, if it has some; else the first vertex is the texture's lower left corner, the second its
     * upper left, the third its lower right.
     */
    @Override
    public void textureCoordinates(Hit hit) {
        plane.textureCoordinates(hit);
        if (uv != null) {
            double s = 1 - hit.v;
            double t = hit.u;
            hit.u = uv.u(s, t);
            hit.v = 1 - uv.v(s, t);
        }
    }

    /** False where the corners' texture coordinates are collinear. */
    @Override
    public boolean textureDirections(Hit hit) {
        if (uv != null) {
            Vec3[] directions = uv.directions(b.minus(a), c.minus(a));
            if (directions != null) {
                hit.setTextureDirections(directions[0], directions[1]);
            }
            return directions != null;
        }
        hit.setTextureDirections(c.minus(a), b.minus(a));
        return true;
    }

    /** True for coordinates given at corners, which continue beyond 0..1 as those of a mesh. */
    @Override
    public boolean repeatsTextures() {
        return uv != null;
    }

    @Override
    public boolean hasTextureDirections() {
        return true;
    }

    @Override
    public Bounds bounds() {
        return Bounds.of(a, b, c);
    }

    @Override
    public boolean isFlat() {
        return true;
    }

    @Override
    public SupportSurface support(int face) {
        return SupportSurface.Plane.of(plane.n, a, b, c);
    }

    @Override
    public FlatForm flatForm() {
        double[] ofCorners = uv == null ? new double[] {0} : uv.appendTo(new double[] {1});
        return FlatForm.of(FlatForm.Kind.TRIANGLE, plane.flatForm(), concat(a, b, c), ofCorners);
    }

    @Override
    Primitive scaledBy(int k) {
        return new TrianglePrimitive(plane.degenerateNormal(), a.scaledBy(k), b.scaledBy(k), c.scaledBy(k), uv);
    }

    @Override
    public double[] parameters() {
        return uv == null ? concat(a, b, c) : uv.appendTo(concat(a, b, c));
    }
}

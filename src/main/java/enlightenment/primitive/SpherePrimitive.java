package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Angles;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A sphere, intersected by moments: with f = o − c and m = f × d, the discriminant is r²d² − m², which loses nothing
 * however far the origin is, because every component of m is accurate to 1.5 ulp (Haines, Günther and Akenine-Möller,
 * "Precision improvements for ray/sphere intersection", Ray Tracing Gems ch. 7, taken one step further).
 */
public final class SpherePrimitive extends Primitive {
    /** While s/b is at most this, the difference b − s loses at most two bits. */
    private static final double SAFE_RATIO = 0.75;

    private static final double TWO_PI = 2 * Math.PI;

    private final double cx;
    private final double cy;
    private final double cz;
    private final double radius;

    /** The unit direction of the texture's zero meridian in the x-z plane: one object for many spheres. */
    private final Vec3 meridian;

    /**
     * @param center the centre
     * @param radius the radius, greater than 0
     * @param meridian the zero meridian's direction, of length 1, in the x-z plane
     */
    SpherePrimitive(Vec3 center, double radius, Vec3 meridian) {
        super(center.maxAbs() + radius, radius);
        this.cx = center.x();
        this.cy = center.y();
        this.cz = center.z();
        this.radius = radius;
        this.meridian = meridian;
    }

    /** The centre. */
    public Vec3 center() {
        return new Vec3(cx, cy, cz);
    }

    /** The centre's x. */
    public double x() {
        return cx;
    }

    /** The centre's y. */
    public double y() {
        return cy;
    }

    /** The centre's z. */
    public double z() {
        return cz;
    }

    /** The radius. */
    public double radius() {
        return radius;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        double discriminant = radius * radius * ray.dd - (mx * mx + my * my + mz * mz);
        if (ray.start == this) {
            return ray.startSide == Ray.OUTSIDE ? MISS : farEnd(ray, fx, fy, fz, Math.max(discriminant, 0), tMax);
        }
        if (!(discriminant >= 0)) {
            return MISS;
        }
        double b = -(fx * ray.dx + fy * ray.dy + fz * ray.dz);
        double s = Math.sqrt(discriminant);
        // The body of near(), repeated: it makes this method too long for the JIT compiler to inline at each of its
        // many call sites, which
        // saves a third of the compilation time of a short render (docs/notes/benchmarks.md).
        double near = b > 0 && s > b * SAFE_RATIO
                ? Products.distanceSquaredMinus(fx, fy, fz, radius) / (b + s)
                : (b - s) / ray.dd;
        double far = b < 0 && s > -b * SAFE_RATIO
                ? Products.distanceSquaredMinus(fx, fy, fz, radius) / (b - s)
                : (b + s) / ray.dd;
        double t = near >= ray.tMin ? near : far;
        return t >= ray.tMin && t <= tMax ? t : MISS;
    }

    /**
     * The smaller root of dd·t² − 2b·t + c = 0, s² = b² − dd·c. Where b and s are close, their difference loses digits, and
     * c/(b + s) is used instead, with c in twice the working precision.
     */
    private double near(Ray ray, double fx, double fy, double fz, double b, double s) {
        return b > 0 && s > b * SAFE_RATIO
                ? Products.distanceSquaredMinus(fx, fy, fz, radius) / (b + s)
                : (b - s) / ray.dd;
    }

    private double farEnd(Ray ray, double fx, double fy, double fz, double discriminant, double tMax) {
        double b = -(fx * ray.dx + fy * ray.dy + fz * ray.dz);
        double t = Math.max((b + Math.sqrt(discriminant)) / ray.dd, ray.tMin);
        return t <= tMax ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        double discriminant = Math.max(radius * radius * ray.dd - (mx * mx + my * my + mz * mz), 0);
        double b = -(fx * ray.dx + fy * ray.dy + fz * ray.dz);
        // The two crossings lie at the foot of the perpendicular ∓ a half chord; the same comparison as in nearest.
        double s = Math.sqrt(discriminant);
        boolean entering = ray.start != this && near(ray, fx, fy, fz, b, s) >= ray.tMin;
        double half = (entering ? -s : s) / ray.dd;
        double vx = Math.fma(half, ray.dx, Products.difference(ray.dy, mz, ray.dz, my) / ray.dd);
        double vy = Math.fma(half, ray.dy, Products.difference(ray.dz, mx, ray.dx, mz) / ray.dd);
        double vz = Math.fma(half, ray.dz, Products.difference(ray.dx, my, ray.dy, mx) / ray.dd);
        hit.setNormal(vx, vy, vz);
        hit.setPoint(Math.fma(radius, hit.nx, cx), Math.fma(radius, hit.ny, cy), Math.fma(radius, hit.nz, cz));
        hit.side = entering ? Ray.OUTSIDE : Ray.INSIDE;
        hit.face = 0;
    }

    @Override
    public void textureCoordinates(Hit hit) {
        // Longitude grows to the right for a viewer outside with +y up; the zero meridian faces -z before rotation.
        double east = hit.nz * meridian.x() - hit.nx * meridian.z();
        double ahead = hit.nx * meridian.x() + hit.nz * meridian.z();
        double turn = Angles.atan2(east, ahead) / TWO_PI;
        hit.u = turn < 0 ? turn + 1 : turn;
        hit.v = Angles.atan2(Math.sqrt(hit.nx * hit.nx + hit.nz * hit.nz), hit.ny) / Math.PI;
    }

    /** False at the poles, where there are none. */
    @Override
    public boolean textureDirections(Hit hit) {
        double level = Math.sqrt(hit.nx * hit.nx + hit.nz * hit.nz);
        double ahead = hit.nx * meridian.x() + hit.nz * meridian.z();
        double east = hit.nz * meridian.x() - hit.nx * meridian.z();
        Vec3 toEast =
                new Vec3(-east * meridian.x() - ahead * meridian.z(), 0, -east * meridian.z() + ahead * meridian.x());
        Vec3 up = new Vec3(-hit.ny * hit.nx / level, level, -hit.ny * hit.nz / level);
        hit.setTextureDirections(toEast.times(TWO_PI * radius), up.times(Math.PI * radius));
        return level > 0;
    }

    @Override
    public boolean hasTextureDirections() {
        return true;
    }

    /** True: u runs around the axis. */
    @Override
    public boolean repeatsTextures() {
        return true;
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(center(), new Vec3(radius, radius, radius));
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public double volume() {
        return 4 * Math.PI / 3 * radius * radius * radius;
    }

    @Override
    public boolean isWhole() {
        return true;
    }

    @Override
    public boolean contains(double x, double y, double z) {
        return Products.distanceSquaredMinus(x - cx, y - cy, z - cz, radius) <= 0;
    }

    @Override
    public SupportSurface support(int face) {
        return new SupportSurface.Ball(center(), radius);
    }

    @Override
    public FlatForm flatForm() {
        return FlatForm.of(FlatForm.Kind.SPHERE, parameters());
    }

    @Override
    Primitive scaledBy(int k) {
        return new SpherePrimitive(center().scaledBy(k), Scale.scalb(radius, k), meridian);
    }

    @Override
    public double[] parameters() {
        return new double[] {cx, cy, cz, radius, meridian.x(), meridian.z()};
    }
}

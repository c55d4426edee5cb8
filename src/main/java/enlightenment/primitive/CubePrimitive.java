package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.frame.Rotation;
import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A cube in any orientation: slabs along its own axes. Faces: 0 = -x, 1 = +x, 2 = -y, 3 = +y, 4 = -z, 5 = +z of its axes.
 *
 * <p>A cube that is turned by quarter turns only is parallel to the world's axes; it is tested as the box that it is, so
 * that it meets its neighbours exactly.
 */
public final class CubePrimitive extends Primitive {
    private static final int FACES = 6;

    /** Bounds the rounding of a product with an axis and of its distance from a face. */
    private static final double SLAB_ERROR = Scale.gamma(8);

    private final Vec3 center;

    /** Half of the edge. */
    private final double half;

    /** The directions of the cube's own axes. */
    private final Vec3 axisX;

    private final Vec3 axisY;
    private final Vec3 axisZ;
    private final Rotation rotation;

    /** The cube as a box; null if it is not parallel to the axes. */
    private final BoxPrimitive box;

    CubePrimitive(Vec3 center, double half, Rotation rotation) {
        super(center.maxAbs() + 2 * half, half);
        this.center = center;
        this.half = half;
        this.rotation = rotation;
        axisX = rotation.axis(0);
        axisY = rotation.axis(1);
        axisZ = rotation.axis(2);
        box = isUnit(axisX) && isUnit(axisY) && isUnit(axisZ) ? box(center, half) : null;
    }

    private static boolean isUnit(Vec3 v) {
        return Math.abs(v.x()) + Math.abs(v.y()) + Math.abs(v.z()) == 1 && v.maxAbs() == 1;
    }

    /** Whether a rotation is the identity. */
    static boolean isUpright(Rotation r) {
        return isUnit(r.r0()) && isUnit(r.r1()) && r.r0().x() == 1 && r.r1().y() == 1 && r.r2().z() == 1;
    }

    /** The cube with faces at center ± half, parallel to the axes. */
    static BoxPrimitive box(Vec3 center, double half) {
        Vec3 h = new Vec3(half, half, half);
        return new BoxPrimitive(center.minus(h), center.plus(h));
    }

    /** The centre. */
    public Vec3 center() {
        return center;
    }

    /** The edge along one of the cube's own axes, from the lower face to the upper one. */
    public Vec3 edge(int k) {
        return (k == 0 ? axisX : k == 1 ? axisY : axisZ).times(2 * half);
    }

    private double origin(Ray ray, Vec3 axis) {
        return Products.dot(
                axis.x(), axis.y(), axis.z(), ray.ox - center.x(), ray.oy - center.y(), ray.oz - center.z());
    }

    private static double direction(Ray ray, Vec3 axis) {
        return Products.accurateDot(axis.x(), axis.y(), axis.z(), ray.dx, ray.dy, ray.dz);
    }

    private double entry(Ray ray, Vec3 axis, double h) {
        return Slabs.entry(origin(ray, axis), direction(ray, axis), -h, h);
    }

    private double exit(Ray ray, Vec3 axis, double h) {
        return Slabs.exit(origin(ray, axis), direction(ray, axis), -h, h);
    }

    private double near(Ray ray, double h) {
        return Slabs.max(entry(ray, axisX, h), entry(ray, axisY, h), entry(ray, axisZ, h));
    }

    private double far(Ray ray, double h) {
        return Slabs.min(exit(ray, axisX, h), exit(ray, axisY, h), exit(ray, axisZ, h));
    }

    /** Half the edge, enlarged by the rounding of slabs: a ray that misses by less may be one that hits. */
    private double widened(Ray ray) {
        double distance = Math.abs(ray.ox - center.x()) + Math.abs(ray.oy - center.y()) + Math.abs(ray.oz - center.z());
        return half + SLAB_ERROR * (distance + half);
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        boolean own = ray.start == this;
        if (box != null) {
            return box.nearest(ray, tMax, own);
        }
        if (own && ray.startSide == Ray.OUTSIDE) {
            return MISS;
        }
        double far = far(ray, half);
        if (own) {
            double t = far >= ray.tMin ? far : ray.tMin;
            return t <= tMax ? t : MISS;
        }
        double near = near(ray, half);
        if (!(near <= far)) {
            near = near(ray, widened(ray));
            far = far(ray, widened(ray));
            if (!(near <= far)) {
                return MISS;
            }
        }
        double t = near >= ray.tMin ? near : far;
        return t >= ray.tMin && t <= tMax ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        boolean own = ray.start == this;
        if (box != null) {
            box.complete(ray, t, hit, own);
            hit.face = ownFace(hit);
            return;
        }
        double h = own || near(ray, half) <= far(ray, half) ? half : widened(ray);
        boolean entering = !own && near(ray, h) >= ray.tMin;
        int k = entering
                ? Slabs.last(entry(ray, axisX, h), entry(ray, axisY, h), entry(ray, axisZ, h))
                : Slabs.first(exit(ray, axisX, h), exit(ray, axisY, h), exit(ray, axisZ, h));
        Vec3 axis = k == 0 ? axisX : k == 1 ? axisY : axisZ;
        boolean upper = entering ? direction(ray, axis) < 0 : direction(ray, axis) > 0;
        double sign = upper ? 1 : -1;
        hit.face = 2 * k + (upper ? 1 : 0);
        hit.side = entering ? Ray.OUTSIDE : Ray.INSIDE;
        hit.setNormal(sign * axis.x(), sign * axis.y(), sign * axis.z());
        // In the cube's own coordinates the point is projected onto the face, as on a box.
        place(
                hit,
                k == 0 ? sign * half : coordinate(ray, t, axisX),
                k == 1 ? sign * half : coordinate(ray, t, axisY),
                k == 2 ? sign * half : coordinate(ray, t, axisZ));
    }

    private double coordinate(Ray ray, double t, Vec3 axis) {
        return Slabs.clamp(Math.fma(t, direction(ray, axis), origin(ray, axis)), -half, half);
    }

    private void place(Hit hit, double x, double y, double z) {
        hit.setPoint(
                center.x() + Products.dot(axisX.x(), axisY.x(), axisZ.x(), x, y, z),
                center.y() + Products.dot(axisX.y(), axisY.y(), axisZ.y(), x, y, z),
                center.z() + Products.dot(axisX.z(), axisY.z(), axisZ.z(), x, y, z));
    }

    /** The cube's own face whose outward normal is the hit's. */
    private int ownFace(Hit hit) {
        double x = axisX.x() * hit.nx + axisX.y() * hit.ny + axisX.z() * hit.nz;
        double y = axisY.x() * hit.nx + axisY.y() * hit.ny + axisY.z() * hit.nz;
        double z = axisZ.x() * hit.nx + axisZ.y() * hit.ny + axisZ.z() * hit.nz;
        return x != 0 ? (x > 0 ? 1 : 0) : y != 0 ? (y > 0 ? 3 : 2) : (z > 0 ? 5 : 4);
    }

    @Override
    public void textureCoordinates(Hit hit) {
        Slabs.textureCoordinates(hit, fraction(hit, axisX), fraction(hit, axisY), fraction(hit, axisZ));
    }

    /** The position of the hit between the two faces perpendicular to one of the cube's axes, 0..1. */
    private double fraction(Hit hit, Vec3 axis) {
        if (box == null) {
            double along = Products.dot(
                    axis.x(), axis.y(), axis.z(), hit.px - center.x(), hit.py - center.y(), hit.pz - center.z());
            return along / (2 * half) + 0.5;
        }
        double world = axis.x() != 0 ? box.fractionX(hit) : axis.y() != 0 ? box.fractionY(hit) : box.fractionZ(hit);
        return axis.x() + axis.y() + axis.z() > 0 ? world : 1 - world;
    }

    @Override
    public Bounds bounds() {
        if (box != null) {
            return box.bounds();
        }
        double slack = half * SLAB_ERROR;
        return Bounds.around(center, new Vec3(extent(0) + slack, extent(1) + slack, extent(2) + slack));
    }

    private double extent(int k) {
        return half * (Math.abs(axisX.component(k)) + Math.abs(axisY.component(k)) + Math.abs(axisZ.component(k)));
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public double volume() {
        return 8 * half * half * half;
    }

    @Override
    public boolean contains(double x, double y, double z) {
        if (box != null) {
            return box.contains(x, y, z);
        }
        Vec3 p = new Vec3(x, y, z).minus(center);
        return Math.abs(axisX.dot(p)) <= half && Math.abs(axisY.dot(p)) <= half && Math.abs(axisZ.dot(p)) <= half;
    }

    @Override
    public int faceCount() {
        return FACES;
    }

    @Override
    public SupportSurface support(int face) {
        Vec3 axis = face / 2 == 0 ? axisX : face / 2 == 1 ? axisY : axisZ;
        Vec3 p = (face / 2 == 0 ? axisY : axisX).times(half);
        Vec3 q = (face / 2 == 2 ? axisY : axisZ).times(half);
        Vec3 out = face % 2 == 1 ? axis : axis.negated();
        Vec3 middle = center.plus(out.times(half));
        return SupportSurface.Plane.of(
                out,
                middle.minus(p).minus(q),
                middle.plus(p).minus(q),
                middle.plus(p).plus(q),
                middle.minus(p).plus(q));
    }

    @Override
    public FlatForm flatForm() {
        double[] asBox = box == null ? new double[] {0} : new double[] {1};
        return FlatForm.of(FlatForm.Kind.CUBE, parameters(), asBox, box == null ? new double[0] : box.parameters());
    }

    @Override
    Primitive scaledBy(int k) {
        return new CubePrimitive(center.scaledBy(k), Scale.scalb(half, k), rotation);
    }

    @Override
    public double[] parameters() {
        double[] axes = concat(axisX, axisY, axisZ);
        double[] all = new double[axes.length + 4];
        System.arraycopy(concat(center), 0, all, 0, 3);
        all[3] = half;
        System.arraycopy(axes, 0, all, 4, axes.length);
        return all;
    }
}

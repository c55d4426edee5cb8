package enlightenment.geometry;

import enlightenment.math.Bounds;
import enlightenment.math.Products;
import enlightenment.math.Rotation;
import enlightenment.math.Scale;
import enlightenment.math.Vec3;

/**
 * A cube in any orientation: slabs along its own axes. Faces: 0 = -x, 1 = +x, 2 = -y, 3 = +y, 4 = -z, 5 = +z of its axes.
 */
public final class CubePrimitive extends Primitive {
    private static final int FACES = 6;

    private final Vec3 center;

    /** Half of the edge. */
    private final double half;

    /** The directions of the cube's own axes. */
    private final Vec3 axisX;

    private final Vec3 axisY;
    private final Vec3 axisZ;
    private final Rotation rotation;

    CubePrimitive(Vec3 center, double half, Rotation rotation) {
        super(center.maxAbs() + 2 * half, half);
        this.center = center;
        this.half = half;
        this.rotation = rotation;
        axisX = rotation.axis(0);
        axisY = rotation.axis(1);
        axisZ = rotation.axis(2);
    }

    private double origin(Ray ray, Vec3 axis) {
        return axis.x() * (ray.ox - center.x())
                + Products.sum(axis.y(), ray.oy - center.y(), axis.z(), ray.oz - center.z());
    }

    private static double direction(Ray ray, Vec3 axis) {
        return Products.dot(axis.x(), axis.y(), axis.z(), ray.dx, ray.dy, ray.dz);
    }

    private double entry(Ray ray, Vec3 axis) {
        return Slabs.entry(origin(ray, axis), direction(ray, axis), -half, half);
    }

    private double exit(Ray ray, Vec3 axis) {
        return Slabs.exit(origin(ray, axis), direction(ray, axis), -half, half);
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this && ray.startSide == Ray.OUTSIDE) {
            return MISS;
        }
        double far = Slabs.least(exit(ray, axisX), exit(ray, axisY), exit(ray, axisZ));
        if (ray.start == this) {
            double t = far >= ray.tMin ? far : ray.tMin;
            return t <= tMax ? t : MISS;
        }
        double near = Slabs.greatest(entry(ray, axisX), entry(ray, axisY), entry(ray, axisZ));
        if (!(near <= far)) {
            return MISS;
        }
        double t = near >= ray.tMin ? near : far;
        return t >= ray.tMin && t <= tMax ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        double ex = entry(ray, axisX);
        double ey = entry(ray, axisY);
        double ez = entry(ray, axisZ);
        boolean entering = ray.start != this && Slabs.greatest(ex, ey, ez) >= ray.tMin;
        int k = entering ? Slabs.last(ex, ey, ez) : Slabs.first(exit(ray, axisX), exit(ray, axisY), exit(ray, axisZ));
        Vec3 axis = k == 0 ? axisX : k == 1 ? axisY : axisZ;
        boolean upper = entering ? direction(ray, axis) < 0 : direction(ray, axis) > 0;
        double sign = upper ? 1 : -1;
        hit.face = 2 * k + (upper ? 1 : 0);
        hit.side = entering ? Ray.OUTSIDE : Ray.INSIDE;
        hit.setNormal(sign * axis.x(), sign * axis.y(), sign * axis.z());
        double x = Math.fma(t, ray.dx, ray.ox) - center.x();
        double y = Math.fma(t, ray.dy, ray.oy) - center.y();
        double z = Math.fma(t, ray.dz, ray.oz) - center.z();
        // Onto the face: far from the origin of the ray, t·d is rounded more coarsely than the face.
        double off = sign * half - Products.accurateDot(axis.x(), axis.y(), axis.z(), x, y, z);
        hit.setPoint(
                center.x() + Math.fma(off, axis.x(), x),
                center.y() + Math.fma(off, axis.y(), y),
                center.z() + Math.fma(off, axis.z(), z));
    }

    @Override
    public void textureCoordinates(Hit hit) {
        Vec3 p = hit.point().minus(center);
        double edge = 2 * half;
        Slabs.textureCoordinates(hit, axisX.dot(p) / edge + 0.5, axisY.dot(p) / edge + 0.5, axisZ.dot(p) / edge + 0.5);
    }

    @Override
    public Bounds bounds() {
        double slack = half * Scale.gamma(8);
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
    public boolean contains(double x, double y, double z) {
        Vec3 p = new Vec3(x, y, z).minus(center);
        return Math.abs(axisX.dot(p)) <= half && Math.abs(axisY.dot(p)) <= half && Math.abs(axisZ.dot(p)) <= half;
    }

    @Override
    public int faceCount() {
        return FACES;
    }

    @Override
    Primitive scaledBy(int k) {
        return new CubePrimitive(center.scaledBy(k), Scale.scalb(half, k), rotation);
    }

    @Override
    public double[] parameters() {
        double[] axes = concat(axisX, axisY, axisZ);
        double[] all = {center.x(), center.y(), center.z(), half, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        System.arraycopy(axes, 0, all, 4, axes.length);
        return all;
    }
}

package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A flat disk. With the moment m about its centre and the normal N, the line meets the disk's plane at the offset
 * N × m / (d·N) from the centre: a form that depends neither on the ray's origin nor on its parameter, and that lies in the
 * plane without being projected.
 */
public final class DiskPrimitive extends Primitive {
    private final Vec3 center;
    private final double cx;
    private final double cy;
    private final double cz;

    /** The normal with a largest component in [1, 2). */
    private final Vec3 normal;

    private final double nx;
    private final double ny;
    private final double nz;
    private final Vec3 unitNormal;
    private final double radius;

    /** The coordinate axis that the normal is parallel to, or -1. */
    private final int aligned;

    /** Right and up for a viewer in front of the disk: the axes of its texture. */
    private final Vec3 right;

    private final Vec3 up;

    /**
     * @param center the centre
     * @param normal a normal that points to {@link Ray#OUTSIDE}, of any length but 0
     * @param radius greater than 0
     */
    DiskPrimitive(Vec3 center, Vec3 normal, double radius) {
        super(center.maxAbs() + radius, radius);
        this.center = center;
        this.radius = radius;
        cx = center.x();
        cy = center.y();
        cz = center.z();
        this.normal = normal.scaledBy(-normal.exponent());
        nx = this.normal.x();
        ny = this.normal.y();
        nz = this.normal.z();
        unitNormal = Disks.unit(this.normal);
        aligned = Disks.alignedAxis(this.normal);
        boolean lying = Math.abs(ny) > Math.abs(nx) && Math.abs(ny) > Math.abs(nz);
        Vec3 preferred = lying ? new Vec3(0, 0, Math.signum(ny)) : Vec3.Y;
        up = unitNormal.cross(preferred.cross(unitNormal)).normalized();
        right = unitNormal.cross(up);
    }

    /** The centre. */
    public Vec3 center() {
        return center;
    }

    /** The unit normal. */
    public Vec3 normal() {
        return unitNormal;
    }

    /** The radius. */
    public double radius() {
        return radius;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        if (ray.start == this) {
            return MISS;
        }
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        double e = Products.accurateDot(nx, ny, nz, ray.dx, ray.dy, ray.dz);
        double t =
                switch (aligned) {
                    case 0 -> (cx - ray.ox) / ray.dx;
                    case 1 -> (cy - ray.oy) / ray.dy;
                    case 2 -> (cz - ray.oz) / ray.dz;
                    default -> -Products.accurateDot(nx, ny, nz, fx, fy, fz) / e;
                };
        if (!(t >= ray.tMin && t <= tMax) || e == 0) {
            return MISS;
        }
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        double vx = Products.difference(ny, mz, nz, my);
        double vy = Products.difference(nz, mx, nx, mz);
        double vz = Products.difference(nx, my, ny, mx);
        double rim = radius * e;
        return vx * vx + vy * vy + vz * vz <= rim * rim ? t : MISS;
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        double e = Products.accurateDot(nx, ny, nz, ray.dx, ray.dy, ray.dz);
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        hit.setPoint(
                cx + Products.difference(ny, mz, nz, my) / e,
                cy + Products.difference(nz, mx, nx, mz) / e,
                cz + Products.difference(nx, my, ny, mx) / e);
        hit.nx = unitNormal.x();
        hit.ny = unitNormal.y();
        hit.nz = unitNormal.z();
        hit.side = e < 0 ? Ray.OUTSIDE : Ray.INSIDE;
        hit.face = 0;
    }

    @Override
    public void textureCoordinates(Hit hit) {
        Disks.textureCoordinates(hit, hit.point().minus(center), right, up, radius);
    }

    @Override
    public Bounds bounds() {
        return Disks.bounds(center, unitNormal, radius);
    }

    @Override
    public boolean isFlat() {
        return true;
    }

    @Override
    public SupportSurface support(int face) {
        return SupportSurface.Plane.ofDisk(center, unitNormal, radius);
    }

    @Override
    public FlatForm flatForm() {
        return FlatForm.of(
                FlatForm.Kind.DISK,
                concat(center, normal, unitNormal),
                new double[] {radius, aligned},
                concat(right, up));
    }

    @Override
    Primitive scaledBy(int k) {
        return new DiskPrimitive(center.scaledBy(k), normal, Scale.scalb(radius, k));
    }

    @Override
    public double[] parameters() {
        return new double[] {cx, cy, cz, nx, ny, nz, radius};
    }
}

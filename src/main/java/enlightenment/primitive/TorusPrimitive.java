package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Angles;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * A solid torus: all points within {@link #minorRadius} of a circle, the ring.
 *
 * <p>The line is moved into the torus's frame at its point closest to the centre, which is found by moments as for a
 * sphere, so that nothing is lost however far the ray's origin is; {@link TorusLine} does the rest. A ray that starts on
 * the torus may meet it again.
 */
public final class TorusPrimitive extends Primitive {
    private static final double TWO_PI = 2 * Math.PI;

    private final double cx;
    private final double cy;
    private final double cz;

    /** The frame: the unit axis, the direction of the texture's seam in the ring's plane, and that to its right. */
    private final double ax;

    private final double ay;
    private final double az;
    private final double seamX;
    private final double seamY;
    private final double seamZ;
    private final double eastX;
    private final double eastY;
    private final double eastZ;

    private final double majorRadius;
    private final double minorRadius;
    private final double boundingSquare;

    /**
     * @param center the centre of the ring
     * @param axis the unit vector that the ring's plane is perpendicular to
     * @param majorRadius the radius of the ring
     * @param minorRadius the radius of the tube, greater than 0 and at most that of the ring
     */
    TorusPrimitive(Vec3 center, Vec3 axis, double majorRadius, double minorRadius) {
        super(center.maxAbs() + majorRadius + minorRadius, minorRadius);
        cx = center.x();
        cy = center.y();
        cz = center.z();
        ax = axis.x();
        ay = axis.y();
        az = axis.z();
        // The smallest rotation that takes ±y to the axis, applied to -z and x (Duff et al., "Building an orthonormal
        // basis,
        // revisited", JCGT 2017, with y as the pole).
        double sign = ay < 0 ? -1 : 1;
        double k = 1 / (1 + Math.abs(ay));
        seamX = ax * az * k;
        seamY = sign * az;
        seamZ = az * az * k - 1;
        eastX = sign * (1 - ax * ax * k);
        eastY = -ax;
        eastZ = -sign * (ax * az * k);
        this.majorRadius = majorRadius;
        this.minorRadius = minorRadius;
        double reach = majorRadius + minorRadius;
        boundingSquare = reach * reach * TorusLine.SLACK;
    }

    /** The centre of the ring. */
    public Vec3 center() {
        return new Vec3(cx, cy, cz);
    }

    /** The unit vector along the axis of rotation. */
    public Vec3 axis() {
        return new Vec3(ax, ay, az);
    }

    /** The radius of the ring: from the centre to the middle of the tube. */
    public double majorRadius() {
        return majorRadius;
    }

    /** The radius of the tube. */
    public double minorRadius() {
        return minorRadius;
    }

    @Override
    double nearestOrdinary(Ray ray, double tMax) {
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        if (ray.start == this) {
            return nearestFromSurface(ray, fx, fy, fz, tMax);
        }
        double mx = Products.difference(fy, ray.dz, fz, ray.dy);
        double my = Products.difference(fz, ray.dx, fx, ray.dz);
        double mz = Products.difference(fx, ray.dy, fy, ray.dx);
        if (mx * mx + my * my + mz * mz > boundingSquare * ray.dd) {
            return MISS;
        }
        TorusLine line = lineOf(ray);
        double s = 1 / ray.dd;
        setBase(
                line,
                Products.difference(ray.dy, mz, ray.dz, my) * s,
                Products.difference(ray.dz, mx, ray.dx, mz) * s,
                Products.difference(ray.dx, my, ray.dy, mx) * s);
        double tClosest = -Products.accurateDot(fx, fy, fz, ray.dx, ray.dy, ray.dz) / ray.dd;
        line.begin(majorRadius, minorRadius, tClosest, Math.sqrt(ray.dd));
        return line.fromFar(ray.tMin, tMax);
    }

    private double nearestFromSurface(Ray ray, double fx, double fy, double fz, double tMax) {
        TorusLine line = lineOf(ray);
        setBase(line, fx, fy, fz);
        line.begin(majorRadius, minorRadius, 0, Math.sqrt(ray.dd));
        return line.fromSurface(ray.startSide, ray.tMin, tMax);
    }

    /** The ray's scratch object, with its direction in this torus's frame. */
    private TorusLine lineOf(Ray ray) {
        TorusLine line = ray.torusLine;
        if (line == null) {
            line = new TorusLine();
            ray.torusLine = line;
        }
        double k = 1 / Math.sqrt(ray.dd);
        double ex = ray.dx * k;
        double ey = ray.dy * k;
        double ez = ray.dz * k;
        line.ex = Products.dot(seamX, seamY, seamZ, ex, ey, ez);
        line.ey = Products.dot(eastX, eastY, eastZ, ex, ey, ez);
        line.ez = Products.dot(ax, ay, az, ex, ey, ez);
        return line;
    }

    private void setBase(TorusLine line, double x, double y, double z) {
        line.bx = Products.dot(seamX, seamY, seamZ, x, y, z);
        line.by = Products.dot(eastX, eastY, eastZ, x, y, z);
        line.bz = Products.dot(ax, ay, az, x, y, z);
    }

    @Override
    void completeOrdinary(Ray ray, double t, Hit hit) {
        // The search is repeated: it is a function of the ray, so it finds the same crossing, and tells which one it
        // is.
        if (nearestOrdinary(ray, Double.MAX_VALUE) == MISS) {
            throw new IllegalArgumentException("no crossing at t = " + t);
        }
        TorusLine line = ray.torusLine;
        double x = Math.fma(line.s, line.ex, line.bx);
        double y = Math.fma(line.s, line.ey, line.by);
        double z = Math.fma(line.s, line.ez, line.bz);
        double rho = Math.sqrt(x * x + y * y);
        // The centre of a horn torus is on the axis: any direction from the axis will do.
        double outX = rho > 0 ? x / rho : 1;
        double outY = rho > 0 ? y / rho : 0;
        double w = rho - majorRadius;
        double tube = Math.sqrt(w * w + z * z);
        // If the tube is thinner than the rounding of its ring, the hit may be on the ring: that counts as its outer
        // side.
        double radial = tube > 0 ? w / tube : 1;
        double up = tube > 0 ? z / tube : 0;
        double nx = radial * outX;
        double ny = radial * outY;
        hit.setNormal(
                Products.dot(seamX, eastX, ax, nx, ny, up),
                Products.dot(seamY, eastY, ay, nx, ny, up),
                Products.dot(seamZ, eastZ, az, nx, ny, up));
        double distance = Math.fma(minorRadius, radial, majorRadius);
        double px = distance * outX;
        double py = distance * outY;
        double pz = minorRadius * up;
        hit.setPoint(
                cx + Products.dot(seamX, eastX, ax, px, py, pz),
                cy + Products.dot(seamY, eastY, ay, px, py, pz),
                cz + Products.dot(seamZ, eastZ, az, px, py, pz));
        hit.side = line.side;
        hit.face = 0;
    }

    /**
     * u runs around the ring, to the right for a viewer outside with the axis up; its seam faces -z if the axis is
     * ±y, and otherwise the direction that the smallest rotation from ±y to the axis takes -z to. v runs around the tube, from the inner
     * equator over the top (0.25), the outer equator (0.5) and the bottom (0.75) back to it.
     */
    @Override
    public void textureCoordinates(Hit hit) {
        Vec3 offset = hit.point().minus(center());
        Vec3 p = offset.scaledBy(-offset.exponent());
        double ahead = Products.dot(seamX, seamY, seamZ, p.x(), p.y(), p.z());
        double east = Products.dot(eastX, eastY, eastZ, p.x(), p.y(), p.z());
        double turn = Angles.atan2(east, ahead) / TWO_PI;
        hit.u = turn < 0 ? turn + 1 : turn;
        double up = Products.dot(ax, ay, az, hit.nx, hit.ny, hit.nz);
        double outward = ahead * Products.dot(seamX, seamY, seamZ, hit.nx, hit.ny, hit.nz)
                + east * Products.dot(eastX, eastY, eastZ, hit.nx, hit.ny, hit.nz);
        double rho = Math.sqrt(ahead * ahead + east * east);
        hit.v = 0.5 - Angles.atan2(up, rho > 0 ? outward / rho : -1) / TWO_PI;
    }

    @Override
    public Bounds bounds() {
        return Bounds.around(center(), new Vec3(halfExtent(ay, az), halfExtent(az, ax), halfExtent(ax, ay)));
    }

    /** The extent along a coordinate axis, given the torus axis's components along the other two. */
    private double halfExtent(double a, double b) {
        return Math.fma(majorRadius, Math.sqrt(a * a + b * b), minorRadius) * (1 + Scale.gamma(8));
    }

    @Override
    public boolean isConvex() {
        return false;
    }

    @Override
    public boolean isSolid() {
        return true;
    }

    @Override
    public double volume() {
        return 2 * Math.PI * Math.PI * majorRadius * minorRadius * minorRadius;
    }

    @Override
    public boolean isWhole() {
        return true;
    }

    @Override
    public boolean contains(double x, double y, double z) {
        int k = -Scale.exponent(majorRadius);
        double fx = Scale.scalb(x - cx, k);
        double fy = Scale.scalb(y - cy, k);
        double fz = Scale.scalb(z - cz, k);
        double ahead = Products.dot(seamX, seamY, seamZ, fx, fy, fz);
        double east = Products.dot(eastX, eastY, eastZ, fx, fy, fz);
        double up = Products.dot(ax, ay, az, fx, fy, fz);
        double w = Math.sqrt(ahead * ahead + east * east) - Scale.scalb(majorRadius, k);
        double r = Scale.scalb(minorRadius, k);
        return (w - r) * (w + r) + up * up <= 0;
    }

    @Override
    public SupportSurface support(int face) {
        return new Ring(center(), axis(), majorRadius, minorRadius);
    }

    @Override
    Primitive scaledBy(int k) {
        return new TorusPrimitive(
                center().scaledBy(k), axis(), Scale.scalb(majorRadius, k), Scale.scalb(minorRadius, k));
    }

    @Override
    public double[] parameters() {
        return new double[] {cx, cy, cz, ax, ay, az, majorRadius, minorRadius};
    }

    /** A whole torus: the points at the distance {@code minorRadius} from a circle. */
    private record Ring(Vec3 center, Vec3 unitAxis, double majorRadius, double minorRadius) implements SupportSurface {
        @Override
        public boolean coincides(SupportSurface other, double tolerance) {
            return other instanceof Ring o
                    && center.minus(o.center).maxAbs() <= tolerance
                    && Math.abs(majorRadius - o.majorRadius) <= tolerance
                    && Math.abs(minorRadius - o.minorRadius) <= tolerance
                    && unitAxis.cross(o.unitAxis).length() * (majorRadius + minorRadius) <= tolerance;
        }

        @Override
        public boolean passes(Vec3 point, double tolerance) {
            Vec3 p = point.minus(center);
            double w = p.cross(unitAxis).length() - majorRadius;
            double z = p.dot(unitAxis);
            return Math.abs(Math.sqrt(w * w + z * z) - minorRadius) <= tolerance;
        }

        @Override
        public Vec3 outward(Vec3 point) {
            Vec3 at = point.minus(center);
            Vec3 axis = unitAxis.normalized();
            Vec3 away = at.minus(axis.times(at.dot(axis))).normalized();
            return at.minus(away.times(majorRadius));
        }

        @Override
        public boolean overlaps(SupportSurface other, double tolerance) {
            return true;
        }

        @Override
        public double extent() {
            return majorRadius + minorRadius;
        }
    }
}

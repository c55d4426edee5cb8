package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;

/**
 * A circular cone or frustum, of any two radii, equal ones included.
 *
 * <p>For a point cone, with the moment m about the apex and the slope k = r/|A|, the line meets the double cone where
 * k|A × m| ≥ |m·A|. A frustum is the part of a cone whose apex lies n/k behind the narrower end, n its radius; about
 * that apex the moment is m − (n/k)·(d × A)/|A|, so with q = k·m − (n/|A|)·(d × A), which needs no apex and turns into
 * the cylinder's form as k vanishes, the discriminant is (|A × q| − |m·A|)(|A × q| + |m·A|) for every ratio of the
 * radii. The mirror nappe is never within the planes of the ends.
 */
public final class ConePrimitive extends AxialPrimitive {
    /** Narrower radius over length, and times length. */
    private final double narrowOverLength;

    private final double narrowTimesLength;

    /**
     * @param base centre of the base
     * @param top centre of the other end, the apex where {@code topRadius} is 0
     * @param baseRadius radius at the base, at least 0
     * @param topRadius radius at the other end, at least 0; one of the two is greater than 0
     * @param capped whether the ends are closed; if not, only the lateral surface can be hit
     */
    ConePrimitive(Vec3 base, Vec3 top, double baseRadius, double topRadius, boolean capped) {
        this(base, top, top.minus(base), baseRadius, topRadius, capped);
    }

    ConePrimitive(Vec3 base, Vec3 top, Vec3 towardsTop, double baseRadius, double topRadius, boolean capped) {
        super(base, top, towardsTop, baseRadius, topRadius, capped);
        narrowOverLength = narrowRadius / length;
        narrowTimesLength = narrowRadius * length;
    }

    @Override
    double crossing(Ray ray, double tMax, Hit hit) {
        if (leavesOutside(ray)) {
            return MISS;
        }
        boolean started = ray.start == this;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double fx = ray.ox - cx;
        double fy = ray.oy - cy;
        double fz = ray.oz - cz;
        double mx = Products.difference(fy, dz, fz, dy);
        double my = Products.difference(fz, dx, fx, dz);
        double mz = Products.difference(fx, dy, fy, dx);
        if (!started && mx * mx + my * my + mz * mz > reachSquared * ray.dd) {
            return MISS;
        }
        double inv = 1 / ray.dd;
        double px = Products.difference(dy, mz, dz, my) * inv;
        double py = Products.difference(dz, mx, dx, mz) * inv;
        double pz = Products.difference(dx, my, dy, mx) * inv;
        double ux = Products.difference(dy, az, dz, ay);
        double uy = Products.difference(dz, ax, dx, az);
        double uz = Products.difference(dx, ay, dy, ax);
        double uu = ux * ux + uy * uy + uz * uz;
        double h = Products.dot(px, py, pz, ax, ay, az);
        double e = Products.dot(dx, dy, dz, ax, ay, az);
        double widening = slope * e;
        double a = uu - widening * widening;
        double moment = LateralInterval.axialMoment(mx * ax, my * ay, mz * az, px * ux, py * uy, pz * uz);
        double discriminant = discriminant(moment, mx, my, mz, ux, uy, uz);
        if (!(discriminant >= 0)) {
            // A line within the cone's directions always meets it.
            if (!started && a > 0) {
                return MISS;
            }
            discriminant = 0;
        }
        double wx = Products.difference(py, az, pz, ay);
        double wy = Products.difference(pz, ax, px, az);
        double wz = Products.difference(px, ay, py, ax);
        // The surface's radius at the foot's height, times the axis' length.
        double radius = Math.fma(slope, h, narrowTimesLength);
        double b = wx * ux + wy * uy + wz * uz - widening * radius;
        double c = Products.distanceSquaredMinus(wx, wy, wz, radius);
        double s = length * Math.sqrt(discriminant);
        double foot = -(fx * dx + fy * dy + fz * dz) * inv;
        double lo = LateralInterval.lower(a, b, c, s, e);
        double hi = LateralInterval.upper(a, b, c, s, e);
        if (slope > 1 && a < 0 && isCapped()) {
            // A line within a flat cone's directions meets it if and only if it meets the disk of the wider end. At the
            // sharp
            // rim the crossings of the lateral surface and of the plane are so close that their order is less reliable.
            boolean through =
                    meetsDisk(Math.fma(unit, ux, mx), Math.fma(unit, uy, my), Math.fma(unit, uz, mz), wideRadius * e);
            if (!through && !started) {
                return MISS;
            }
            double toWide = (extent - h) / e;
            lo = e > 0 ? Math.min(lo, toWide) : lo;
            hi = e < 0 ? Math.max(hi, toWide) : hi;
        }
        return cut(ray, tMax, hit, foot, lo, hi, h, e);
    }

    /** Whether the line with this moment about an end's centre meets the end's disk; {@code rim} is its radius times d·A. */
    private boolean meetsDisk(double kx, double ky, double kz, double rim) {
        double vx = Products.difference(ay, kz, az, ky);
        double vy = Products.difference(az, kx, ax, kz);
        double vz = Products.difference(ax, ky, ay, kx);
        return vx * vx + vy * vy + vz * vz <= rim * rim;
    }

    private double discriminant(double moment, double mx, double my, double mz, double ux, double uy, double uz) {
        double qx = Math.fma(slope, mx, -narrowOverLength * ux);
        double qy = Math.fma(slope, my, -narrowOverLength * uy);
        double qz = Math.fma(slope, mz, -narrowOverLength * uz);
        double vx = Products.difference(ay, qz, az, qy);
        double vy = Products.difference(az, qx, ax, qz);
        double vz = Products.difference(ax, qy, ay, qx);
        return Math.fma(-moment, moment, vx * vx + vy * vy + vz * vz);
    }

    @Override
    double[] flatNumbers() {
        return new double[] {1, 0, 0, narrowOverLength, narrowTimesLength};
    }

    @Override
    Primitive scaledBy(int k) {
        return new ConePrimitive(
                base().scaledBy(k),
                top().scaledBy(k),
                Sizes.scaled(towardsTop(), k),
                Sizes.scaled(baseRadius(), k),
                Sizes.scaled(topRadius(), k),
                isCapped());
    }
}

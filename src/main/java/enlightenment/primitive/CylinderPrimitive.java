package enlightenment.primitive;

import enlightenment.math.Vec3;
import enlightenment.numeric.Products;

/**
 * A circular cylinder: with u = d × A and μ = F·u, the line's distance from the axis is |μ|/|u|, and the
 * discriminant r²u² − μ² loses nothing to the position along the axis (after Cychosz and Waggenspack, "Intersecting a
 * ray with a cylinder", Graphics Gems IV, with the foot F of {@link AxialPrimitive} in the origin's place).
 */
public final class CylinderPrimitive extends AxialPrimitive {
    private final double radiusSquared;
    private final double radiusLength;

    /**
     * @param base centre of the first end
     * @param top centre of the other end
     * @param radius greater than 0
     * @param capped whether the ends are closed; if not, only the lateral surface can be hit
     */
    CylinderPrimitive(Vec3 base, Vec3 top, double radius, boolean capped) {
        this(base, top, top.minus(base), radius, capped);
    }

    CylinderPrimitive(Vec3 base, Vec3 top, Vec3 towardsTop, double radius, boolean capped) {
        super(base, top, towardsTop, radius, radius, capped);
        radiusSquared = radius * radius;
        radiusLength = radius * length;
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
        double moment = LateralInterval.axialMoment(mx * ax, my * ay, mz * az, px * ux, py * uy, pz * uz);
        double discriminant = Products.difference(radiusSquared, uu, moment, moment);
        if (!(discriminant >= 0)) {
            if (!started) {
                return MISS;
            }
            discriminant = 0;
        }
        double wx = Products.difference(py, az, pz, ay);
        double wy = Products.difference(pz, ax, px, az);
        double wz = Products.difference(px, ay, py, ax);
        double b = wx * ux + wy * uy + wz * uz;
        double c = Products.distanceSquaredMinus(wx, wy, wz, radiusLength);
        double s = length * Math.sqrt(discriminant);
        double foot = -(fx * dx + fy * dy + fz * dz) * inv;
        double h = Products.dot(px, py, pz, ax, ay, az);
        double e = Products.dot(dx, dy, dz, ax, ay, az);
        double lo = LateralInterval.lower(uu, b, c, s, e);
        double hi = LateralInterval.upper(uu, b, c, s, e);
        return cut(ray, tMax, hit, foot, lo, hi, h, e);
    }

    @Override
    double[] flatNumbers() {
        return new double[] {0, radiusSquared, radiusLength, 0, 0};
    }

    @Override
    Primitive scaledBy(int k) {
        return new CylinderPrimitive(
                base().scaledBy(k),
                top().scaledBy(k),
                Sizes.scaled(towardsTop(), k),
                Sizes.scaled(baseRadius(), k),
                isCapped());
    }
}

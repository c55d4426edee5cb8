package enlightenment.frame;

import enlightenment.math.Vec3;

/**
 * A closed axis-aligned box.
 *
 * @param min lower corner
 * @param max upper corner; each component at least that of {@code min}
 */
public record Bounds(Vec3 min, Vec3 max) {
    /** The smallest box around one point or several. */
    public static Bounds of(Vec3... points) {
        double x0 = points[0].x();
        double y0 = points[0].y();
        double z0 = points[0].z();
        double x1 = x0;
        double y1 = y0;
        double z1 = z0;
        for (Vec3 p : points) {
            x0 = Math.min(x0, p.x());
            y0 = Math.min(y0, p.y());
            z0 = Math.min(z0, p.z());
            x1 = Math.max(x1, p.x());
            y1 = Math.max(y1, p.y());
            z1 = Math.max(z1, p.z());
        }
        return new Bounds(new Vec3(x0, y0, z0), new Vec3(x1, y1, z1));
    }

    /** The box around a centre with these half extents, rounded outwards. */
    public static Bounds around(Vec3 center, Vec3 halfExtents) {
        return new Bounds(
                new Vec3(
                        Math.nextDown(center.x() - halfExtents.x()),
                        Math.nextDown(center.y() - halfExtents.y()),
                        Math.nextDown(center.z() - halfExtents.z())),
                new Vec3(
                        Math.nextUp(center.x() + halfExtents.x()),
                        Math.nextUp(center.y() + halfExtents.y()),
                        Math.nextUp(center.z() + halfExtents.z())));
    }

    /** The smallest box around this and another box. */
    public Bounds union(Bounds o) {
        return of(min, max, o.min, o.max);
    }

    /** The middle of the box, rounded. */
    public Vec3 center() {
        return min.plus(max).times(0.5);
    }

    /** The lengths of the edges, rounded. */
    public Vec3 extent() {
        return max.minus(min);
    }

    /** A corner of the box, by a number 0 to 7: bit 0 is set for the greatest x, bit 1 for y, bit 2 for z. */
    public Vec3 corner(int k) {
        return new Vec3(
                (k & 1) == 0 ? min.x() : max.x(), (k & 2) == 0 ? min.y() : max.y(), (k & 4) == 0 ? min.z() : max.z());
    }

    /** The largest absolute coordinate. */
    public double maxAbs() {
        return Math.max(min.maxAbs(), max.maxAbs());
    }

    /** Whether the two closed boxes have a point in common. */
    public boolean overlaps(Bounds o) {
        return min.x() <= o.max.x()
                && o.min.x() <= max.x()
                && min.y() <= o.max.y()
                && o.min.y() <= max.y()
                && min.z() <= o.max.z()
                && o.min.z() <= max.z();
    }

    /** Whether the point lies in the closed box. */
    public boolean contains(Vec3 p) {
        return contains(p.x(), p.y(), p.z());
    }

    /** Whether the point lies in the closed box. */
    public boolean contains(double x, double y, double z) {
        return x >= min.x() && x <= max.x() && y >= min.y() && y <= max.y() && z >= min.z() && z <= max.z();
    }
}

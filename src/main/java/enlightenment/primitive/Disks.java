package enlightenment.primitive;

import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** Forms that disks share, whether they are shapes or the ends of a cylinder. */
final class Disks {
    /** Bounds the roundings of a disk's extent and of a point on its rim. */
    private static final double PADDING = 1 + Scale.gamma(16);

    private Disks() {}

    /** The coordinate axis that a direction is parallel to, or -1. */
    static int alignedAxis(Vec3 a) {
        for (int k = 0; k < 3; k++) {
            if (a.component((k + 1) % 3) == 0 && a.component((k + 2) % 3) == 0) {
                return k;
            }
        }
        return -1;
    }

    /** The direction with length 1; exact where it is parallel to a coordinate axis. */
    static Vec3 unit(Vec3 a) {
        return alignedAxis(a) < 0
                ? a.normalized()
                : new Vec3(Math.signum(a.x()) + 0.0, Math.signum(a.y()) + 0.0, Math.signum(a.z()) + 0.0);
    }

    /**
     * The direction from an axis to the seam of a texture around it: as close to -z as possible, or to +y if the axis is closer
     * to z than to x and y.
     */
    static Vec3 seam(Vec3 axis) {
        boolean alongZ = Math.abs(axis.z()) > Math.abs(axis.x()) && Math.abs(axis.z()) > Math.abs(axis.y());
        Vec3 preferred = alongZ ? Vec3.Y : Vec3.Z.negated();
        return axis.cross(preferred.cross(axis)).normalized();
    }

    /** The bounds of a disk, rounded outwards. */
    static Bounds bounds(Vec3 center, Vec3 unitNormal, double radius) {
        double x = unitNormal.x();
        double y = unitNormal.y();
        double z = unitNormal.z();
        double r = radius * PADDING;
        return Bounds.around(
                center,
                new Vec3(r * Math.sqrt(y * y + z * z), r * Math.sqrt(x * x + z * z), r * Math.sqrt(x * x + y * y)));
    }

    /** Maps the square around a disk to 0..1; p is relative to its centre, {@code right} and {@code up} are the texture's. */
    static void textureCoordinates(Hit hit, Vec3 p, Vec3 right, Vec3 up, double radius) {
        hit.u = radius > 0 ? Watertight.clamp01(0.5 + 0.5 * (p.dot(right) / radius)) : 0.5;
        hit.v = radius > 0 ? Watertight.clamp01(0.5 - 0.5 * (p.dot(up) / radius)) : 0.5;
    }
}

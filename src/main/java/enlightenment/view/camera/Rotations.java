package enlightenment.view.camera;

import enlightenment.math.Vec3;

/** Rotations of vectors, by angles in degrees. */
public final class Rotations {
    private Rotations() {}

    /** A vector turned around a unit axis, counterclockwise seen against it (Rodrigues' formula). */
    public static Vec3 turned(Vec3 v, Vec3 axis, double degrees) {
        double angle = StrictMath.toRadians(degrees);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        return v.times(cos).plus(axis.cross(v).times(sin)).plus(axis.times(axis.dot(v) * (1 - cos)));
    }

    /** The angle between two vectors in degrees, 0..180. */
    public static double between(Vec3 a, Vec3 b) {
        return StrictMath.toDegrees(StrictMath.atan2(a.cross(b).length(), a.dot(b)));
    }
}

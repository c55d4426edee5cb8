package enlightenment.geometry;

import enlightenment.math.Check;
import enlightenment.math.Point;
import enlightenment.math.Vec3;

/** Checks of corners that must span an area. */
public final class Parallelograms {
    /** A fourth corner may miss its place by this fraction of the longer edge: what a careful text editor rounds. */
    private static final double CORNER_TOLERANCE = 0x1p-26;

    private Parallelograms() {}

    /** Whether three points lie in one line as far as doubles can tell. */
    public static boolean collinear(Point a, Point b, Point c) {
        Vec3 u = b.minus(a);
        Vec3 v = c.minus(a);
        int e = Math.max(u.exponent(), v.exponent());
        Vec3 p = u.scaledBy(-e);
        Vec3 q = v.scaledBy(-e);
        Vec3 cross = p.cross(q);
        double lengths = p.length() * q.length();
        return !(cross.length() > lengths * Math.ulp(1.0));
    }

    /**
     * Checks that four corners in order form a parallelogram.
     *
     * @param key the key of the scene format that holds them, for the message
     */
    public static void check(String key, Point lowerLeft, Point upperLeft, Point upperRight, Point lowerRight) {
        Check.that(
                !collinear(lowerLeft, upperLeft, lowerRight),
                key,
                "must span an area: the first, second and fourth corner lie in one line or coincide");
        Vec3 up = upperLeft.minus(lowerLeft);
        Vec3 right = lowerRight.minus(lowerLeft);
        Vec3 closing = upperRight.minus(lowerRight);
        int e = Math.max(up.exponent(), right.exponent());
        double miss = closing.scaledBy(-e).minus(up.scaledBy(-e)).length();
        double size = Math.max(up.scaledBy(-e).length(), right.scaledBy(-e).length());
        Check.that(
                miss <= CORNER_TOLERANCE * size,
                key + "/2",
                "must close the parallelogram (first corner + (second − first) + (fourth − first)); it is off by "
                        + miss / size + " of the longer edge");
    }
}

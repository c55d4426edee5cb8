package enlightenment.frame;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;

/** Checks of corners that must span an area. */
public final class Parallelograms {
    /** A fourth corner may miss its place by this fraction of the longer edge: what a careful text editor rounds. */
    private static final double CORNER_TOLERANCE = 0x1p-26;

    private Parallelograms() {}

    /** Whether three points lie exactly in one line. A sliver, however thin, does not. */
    public static boolean collinear(ExactPoint a, ExactPoint b, ExactPoint c) {
        return ExactPoint.inLine(a, b, c);
    }

    /**
     * The normal (b − a) × (c − a) of three points that do not lie in one line, if they do in a frame, where coordinates are
     * rounded; null if they do not. What is left is no more than a line to see, but a line that closes the gap between its
     * neighbours.
     */
    public static Vec3 lostNormal(ExactPoint a, ExactPoint b, ExactPoint c, SceneFrame frame) {
        Vec3 from = frame.toFrame(a);
        Vec3 p = frame.toFrame(b).minus(from);
        Vec3 q = frame.toFrame(c).minus(from);
        boolean flat =
                p.scaledBy(-p.exponent()).cross(q.scaledBy(-q.exponent())).maxAbs() > 0;
        return flat ? null : ExactPoint.normal(a, b, c).normalized();
    }

    /**
     * Checks that four corners in order form a parallelogram.
     *
     * @param key the key of the scene format that holds them, for the message
     */
    public static void check(
            String key, ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight) {
        Check.that(
                !collinear(lowerLeft, upperLeft, lowerRight),
                key,
                "must span an area: the first, second and fourth corner lie in one line or coincide");
        // In units of the longer edge, exactly: a difference may be beyond the range of doubles.
        int e = Math.max(lowerLeft.exponentTo(upperLeft), lowerLeft.exponentTo(lowerRight));
        Vec3 up = new SceneFrame(lowerLeft, e).toFrame(upperLeft);
        Vec3 right = new SceneFrame(lowerLeft, e).toFrame(lowerRight);
        Vec3 closing = new SceneFrame(lowerRight, e).toFrame(upperRight);
        double miss = closing.minus(up).length();
        double size = Math.max(up.length(), right.length());
        Check.that(
                miss <= CORNER_TOLERANCE * size,
                key + "/2",
                "must close the parallelogram (first corner + (second − first) + (fourth − first)); it is off by "
                        + miss / size + " of the longer edge");
    }
}

package enlightenment.frame;

import enlightenment.check.Check;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;

/** Checks and normals of triangles and parallelograms, whose vertices must span an area. */
public final class Parallelograms {
    /** The tolerance of a fourth corner as a fraction of the longer edge: the error of decimals rounded by hand. */
    private static final double CORNER_TOLERANCE = 0x1p-26;

    private Parallelograms() {}

    /**
     * The exact unit normal of a triangle, (b − a) × (c − a) normalised, if rounding to the frame makes its vertices collinear; null if it
     * does not. Such a triangle degenerates to a line, which still closes the gap between its neighbours.
     */
    public static Vec3 normalIfDegenerate(ExactPoint a, ExactPoint b, ExactPoint c, SceneFrame frame) {
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
     * @throws enlightenment.math.InvalidValueException if they span no area, or do not close up to rounding
     */
    public static void check(
            String key, ExactPoint lowerLeft, ExactPoint upperLeft, ExactPoint upperRight, ExactPoint lowerRight) {
        Check.that(
                !ExactPoint.areCollinear(lowerLeft, upperLeft, lowerRight),
                key,
                "must span an area: the first, second and fourth corner lie in one line or coincide");
        // In units of the longer edge, exactly: a difference may be beyond the range of doubles.
        int e = Math.max(lowerLeft.exponentTo(upperLeft), lowerLeft.exponentTo(lowerRight));
        Vec3 up = new SceneFrame(lowerLeft, e).toFrame(upperLeft);
        Vec3 right = new SceneFrame(lowerLeft, e).toFrame(lowerRight);
        Vec3 closing = new SceneFrame(lowerRight, e).toFrame(upperRight);
        double miss = closing.minus(up).length();
        double size = Math.max(up.length(), right.length());
        // The message is only built where it is needed: a scene may have thousands of rectangles.
        if (!(miss <= CORNER_TOLERANCE * size)) {
            throw new InvalidValueException(
                    key + "/2",
                    "must close the parallelogram (first corner + (second − first) + (fourth − first)); it is off by "
                            + miss / size + " of the longer edge");
        }
    }
}

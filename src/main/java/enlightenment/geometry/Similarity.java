package enlightenment.geometry;

import enlightenment.frame.Rotation;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;

/** A transform that keeps shapes what they are: it moves, turns, mirrors, and scales alike in all directions. */
final class Similarity {
    /** Bounds what the steps of a transform may have rounded, relative to the scale. */
    private static final double ROUNDED = Scale.gamma(256);

    private final Transform transform;
    private final double scale;

    /** @throws InvalidValueException (key {@code transform}) if a transform stretches */
    Similarity(Transform transform, String type) {
        this.transform = transform;
        // A power of two is taken out, so that no square leaves the range of doubles.
        int e = transform.applyLinear(Vec3.X).exponent();
        Vec3 a = transform.applyLinear(Vec3.X).scaledBy(-e);
        Vec3 b = transform.applyLinear(Vec3.Y).scaledBy(-e);
        Vec3 c = transform.applyLinear(Vec3.Z).scaledBy(-e);
        double s = a.length();
        boolean isAlike = isClose(b.length(), s) && isClose(c.length(), s);
        double slack = ROUNDED * s * s;
        boolean isSquare = Math.abs(a.dot(b)) <= slack && Math.abs(b.dot(c)) <= slack && Math.abs(c.dot(a)) <= slack;
        if (!isAlike || !isSquare) {
            throw new InvalidValueException(
                    "transform",
                    "stretches a " + type
                            + ", which can be moved, turned, mirrored, and scaled alike in all directions");
        }
        // Where axes go to axes it is exact.
        double exact = transform.keepsAxes() ? Math.max(a.maxAbs(), Math.max(b.maxAbs(), c.maxAbs())) : s;
        scale = Math.scalb(exact, e);
    }

    private static boolean isClose(double length, double s) {
        return Math.abs(length - s) <= ROUNDED * s;
    }

    ExactPoint point(ExactPoint p) {
        return transform.apply(p);
    }

    double length(double length) {
        return scale * length;
    }

    /** A direction, of any length. */
    Vec3 direction(Vec3 v) {
        return transform.applyLinear(v);
    }

    /** Degrees about x, then y, then z, that turn as a rotation by such degrees and then this does. */
    Vec3 angles(Rotation before) {
        double mirrored = transform.isMirror() ? -1 : 1;
        Vec3 x = transform.applyLinear(before.axis(0)).times(mirrored / scale);
        Vec3 y = transform.applyLinear(before.axis(1)).times(mirrored / scale);
        Vec3 z = transform.applyLinear(before.axis(2)).times(mirrored / scale);
        double level = Math.sqrt(x.x() * x.x() + x.y() * x.y());
        if (level > ROUNDED) {
            return degrees(
                    StrictMath.atan2(y.z(), z.z()), StrictMath.atan2(-x.z(), level), StrictMath.atan2(x.y(), x.x()));
        }
        return degrees(StrictMath.atan2(-z.y(), y.y()), StrictMath.atan2(-x.z(), level), 0);
    }

    private static Vec3 degrees(double x, double y, double z) {
        return new Vec3(Math.toDegrees(x), Math.toDegrees(y), Math.toDegrees(z));
    }
}

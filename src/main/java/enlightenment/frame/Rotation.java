package enlightenment.frame;

import enlightenment.math.Vec3;

/**
 * A rotation as an orthonormal matrix, by rows.
 *
 * <p>Angles are degrees; multiples of 90° give exact entries, and the functions used give the same bits on every machine.
 *
 * @param r0 first row
 * @param r1 second row
 * @param r2 third row
 */
public record Rotation(Vec3 r0, Vec3 r1, Vec3 r2) {
    /** The rotation by no angle. */
    public static final Rotation IDENTITY = new Rotation(Vec3.X, Vec3.Y, Vec3.Z);

    /** About +x: y turns towards z. */
    public static Rotation aboutX(double degrees) {
        double c = cos(degrees);
        double s = sin(degrees);
        return new Rotation(Vec3.X, new Vec3(0, c, -s), new Vec3(0, s, c));
    }

    /** About +y: z turns towards x. */
    public static Rotation aboutY(double degrees) {
        double c = cos(degrees);
        double s = sin(degrees);
        return new Rotation(new Vec3(c, 0, s), Vec3.Y, new Vec3(-s, 0, c));
    }

    /** About +z: x turns towards y. */
    public static Rotation aboutZ(double degrees) {
        double c = cos(degrees);
        double s = sin(degrees);
        return new Rotation(new Vec3(c, -s, 0), new Vec3(s, c, 0), Vec3.Z);
    }

    /** About x, then y, then z, by the components of {@code degrees}. */
    public static Rotation ofDegrees(Vec3 degrees) {
        return aboutZ(degrees.z()).times(aboutY(degrees.y())).times(aboutX(degrees.x()));
    }

    /** About an axis of any length, counterclockwise seen from where it points (Rodrigues). */
    public static Rotation about(Vec3 axis, double degrees) {
        Vec3 u = axis.scaledBy(-axis.exponent()).normalized();
        double c = cos(degrees);
        double s = sin(degrees);
        double d = 1 - c;
        return new Rotation(
                new Vec3(c + d * u.x() * u.x(), d * u.x() * u.y() - s * u.z(), d * u.x() * u.z() + s * u.y()),
                new Vec3(d * u.y() * u.x() + s * u.z(), c + d * u.y() * u.y(), d * u.y() * u.z() - s * u.x()),
                new Vec3(d * u.z() * u.x() - s * u.y(), d * u.z() * u.y() + s * u.x(), c + d * u.z() * u.z()));
    }

    /** The rotated vector. */
    public Vec3 apply(Vec3 v) {
        return new Vec3(r0.dot(v), r1.dot(v), r2.dot(v));
    }

    /** The image of axis 0, 1 or 2: a column of the matrix. */
    public Vec3 axis(int k) {
        return new Vec3(r0.component(k), r1.component(k), r2.component(k));
    }

    /** The composition that applies {@code first}, then this rotation. */
    public Rotation times(Rotation first) {
        Vec3 x = apply(first.axis(0));
        Vec3 y = apply(first.axis(1));
        Vec3 z = apply(first.axis(2));
        return new Rotation(
                new Vec3(x.x(), y.x(), z.x()), new Vec3(x.y(), y.y(), z.y()), new Vec3(x.z(), y.z(), z.z()));
    }

    /** The cosine of an angle in degrees, exact at multiples of 90. */
    public static double cos(double degrees) {
        return sin(degrees, 1);
    }

    /** The sine of an angle in degrees, exact at multiples of 90. */
    public static double sin(double degrees) {
        return sin(degrees, 0);
    }

    private static double sin(double degrees, int quarterTurns) {
        double reduced = Math.IEEEremainder(degrees, 360);
        double quarter = Math.rint(reduced / 90);
        double rest = StrictMath.toRadians(reduced - 90 * quarter);
        int q = (int) quarter + quarterTurns & 3;
        double value = (q & 1) == 0 ? StrictMath.sin(rest) : StrictMath.cos(rest);
        return (q & 2) == 0 ? value + 0.0 : 0.0 - value;
    }
}

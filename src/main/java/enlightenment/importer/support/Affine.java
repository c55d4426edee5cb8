package enlightenment.importer.support;

import enlightenment.check.Check;
import enlightenment.geometry.Transform;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;

/**
 * An affine map p → (x·p, y·p, z·p) + offset of foreign coordinates, in doubles. A value.
 *
 * @param x the first row of the linear part
 * @param y the second row
 * @param z the third row
 * @param offset what is added
 */
public record Affine(Vec3 x, Vec3 y, Vec3 z, Vec3 offset) {
    /** The map that changes nothing. */
    public static final Affine IDENTITY = new Affine(Vec3.X, Vec3.Y, Vec3.Z, new Vec3(0, 0, 0));

    /** Adds an offset. */
    public static Affine translate(double dx, double dy, double dz) {
        return new Affine(Vec3.X, Vec3.Y, Vec3.Z, new Vec3(dx, dy, dz));
    }

    /** Multiplies coordinates by factors. */
    public static Affine scale(double sx, double sy, double sz) {
        return new Affine(new Vec3(sx, 0, 0), new Vec3(0, sy, 0), new Vec3(0, 0, sz), new Vec3(0, 0, 0));
    }

    /** Turns about an axis of any length but 0, by degrees, counterclockwise seen from where it points (right-handed). */
    public static Affine rotate(Vec3 axis, double degrees) {
        Transform t = Transform.of(new Transform.RotateAbout(axis, degrees));
        return ofColumns(t.applyLinear(Vec3.X), t.applyLinear(Vec3.Y), t.applyLinear(Vec3.Z), new Vec3(0, 0, 0));
    }

    /** The map whose linear part has these columns: the images of the axes. */
    public static Affine ofColumns(Vec3 a, Vec3 b, Vec3 c, Vec3 offset) {
        return new Affine(
                new Vec3(a.x(), b.x(), c.x()), new Vec3(a.y(), b.y(), c.y()), new Vec3(a.z(), b.z(), c.z()), offset);
    }

    /**
     * The map of 16 numbers of a 4×4 matrix, row by row, for column vectors.
     *
     * @throws IllegalArgumentException if the last row is not 0 0 0 w with w not 0, or a number is not finite
     */
    public static Affine ofRows(double[] m) {
        double w = m[15];
        boolean isAffine = m[12] == 0 && m[13] == 0 && m[14] == 0 && w != 0;
        for (double v : m) {
            isAffine &= Double.isFinite(v / w);
        }
        if (!isAffine) {
            throw new IllegalArgumentException("the last row of a matrix must be 0 0 0 1, and its numbers finite");
        }
        return new Affine(
                new Vec3(m[0] / w, m[1] / w, m[2] / w),
                new Vec3(m[4] / w, m[5] / w, m[6] / w),
                new Vec3(m[8] / w, m[9] / w, m[10] / w),
                new Vec3(m[3] / w, m[7] / w, m[11] / w));
    }

    /**
     * The map from a viewer's coordinates to those of the scene: the origin goes to the eye, +z looks at the target, +y points upwards in the
     * picture, and +x is up × forward (which is left in right-handed coordinates).
     *
     * @throws IllegalArgumentException if eye and target coincide or up lies along the view
     */
    public static Affine lookAt(Vec3 eye, Vec3 target, Vec3 up) {
        Vec3 toTarget = target.minus(eye);
        Vec3 side = up.cross(toTarget);
        if (toTarget.length() == 0 || side.length() == 0) {
            throw new IllegalArgumentException(
                    "a view needs a target apart from its eye, and an up that is not along the view");
        }
        Vec3 forward = toTarget.normalized();
        Vec3 across = side.normalized();
        return ofColumns(across, forward.cross(across), forward, eye);
    }

    /** The map that applies the other one first, then this one (matrix product this · first). */
    public Affine after(Affine first) {
        return ofColumns(
                vector(first.column(0)), vector(first.column(1)), vector(first.column(2)), point(first.offset));
    }

    /** The image of the axis with this number, 0..2. */
    public Vec3 column(int axis) {
        return axis == 0
                ? new Vec3(x.x(), y.x(), z.x())
                : axis == 1 ? new Vec3(x.y(), y.y(), z.y()) : new Vec3(x.z(), y.z(), z.z());
    }

    /** The image of a point. */
    public Vec3 point(Vec3 p) {
        return vector(p).plus(offset);
    }

    /** The image of a direction. */
    public Vec3 vector(Vec3 v) {
        return new Vec3(x.dot(v), y.dot(v), z.dot(v));
    }

    /** The determinant of the linear part: negative where the map mirrors. */
    public double determinant() {
        return x.dot(y.cross(z));
    }

    /**
     * The inverse.
     *
     * @throws IllegalArgumentException if there is none in double precision
     */
    public Affine inverse() {
        double d = determinant();
        Affine linear = ofColumns(
                y.cross(z).times(1 / d), z.cross(x).times(1 / d), x.cross(y).times(1 / d), new Vec3(0, 0, 0));
        if (d == 0 || !linear.x.isFinite() || !linear.y.isFinite() || !linear.z.isFinite()) {
            throw new IllegalArgumentException("a matrix has no inverse: it makes everything flat");
        }
        return new Affine(linear.x, linear.y, linear.z, linear.vector(offset).times(-1));
    }

    /**
     * This map as a transform of scenes.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code matrix} or {@code transform}) if it has no inverse
     */
    public Transform transform() {
        return equals(IDENTITY) ? Transform.IDENTITY : Transform.of(new Transform.Matrix(x, y, z, exact(offset)));
    }

    /**
     * A point of the scene with these coordinates, each the shortest decimal that reads as the same double.
     *
     * @throws enlightenment.math.InvalidValueException for a coordinate that is infinite or NaN
     */
    public static ExactPoint exact(Vec3 p) {
        Check.that(p.isFinite(), "matrix", "must have finite entries");
        return new ExactPoint(BigDecimal.valueOf(p.x()), BigDecimal.valueOf(p.y()), BigDecimal.valueOf(p.z()));
    }
}

package enlightenment.geometry;

import enlightenment.check.Check;
import enlightenment.frame.Rotation;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * An affine map from the coordinates of a mesh or a group to those of what it lies in, as a list of steps that are applied first to last.
 * Immutable. Offsets are exact decimals, so that where the scene's origin lies changes nothing.
 */
public final class Transform {
    /** The map that changes nothing. */
    public static final Transform IDENTITY = new Transform(List.of());

    /** Digits to which an offset is kept once it has been scaled or turned. */
    private static final MathContext DIGITS = new MathContext(60);

    private final List<Step> steps;
    private final ExactPoint offset;

    /** The linear part, row by row: flat, since there may be a million transforms. */
    private final double[] linear;

    /** The matrices of the steps; null until other transforms go on with this one, as those of a group's members do. */
    private List<Matrix> matrices;

    /** A step of a transform. */
    public sealed interface Step permits Scale, Rotate, RotateAbout, Translate, Matrix {}

    /** Multiplies coordinates by factors, finite and not 0; a negative one mirrors. */
    public record Scale(Vec3 factors) implements Step {
        /** @throws enlightenment.math.InvalidValueException for a factor that is 0 or not finite */
        public Scale {
            Check.that(
                    factors.isFinite() && factors.x() != 0 && factors.y() != 0 && factors.z() != 0,
                    "scale",
                    "must be finite and not 0");
        }
    }

    /** Turns by degrees about the x axis, then the y axis, then the z axis. */
    public record Rotate(Vec3 degrees) implements Step {
        /** @throws enlightenment.math.InvalidValueException for an angle that is not finite */
        public Rotate {
            Check.that(degrees.isFinite(), "rotate", "must be three finite numbers");
        }
    }

    /** Turns by degrees about an axis through the origin, counterclockwise seen from where it points. */
    public record RotateAbout(Vec3 axis, double degrees) implements Step {
        /** @throws enlightenment.math.InvalidValueException for an axis without a direction or an angle that is not finite */
        public RotateAbout {
            Check.direction("axis", axis);
            Check.finite("angle", degrees);
        }
    }

    /** Moves by an offset. */
    public record Translate(ExactPoint offset) implements Step {
        /** The offset must be there. */
        public Translate {
            Objects.requireNonNull(offset, "offset");
        }
    }

    /**
     * Multiplies by a matrix, whose rows these are, and adds an offset.
     *
     * @param offset the fourth column
     */
    public record Matrix(Vec3 row0, Vec3 row1, Vec3 row2, ExactPoint offset) implements Step {
        /** @throws enlightenment.math.InvalidValueException for entries that are not finite, and for a matrix without an inverse */
        public Matrix {
            Objects.requireNonNull(offset, "offset");
            Check.that(row0.isFinite() && row1.isFinite() && row2.isFinite(), "matrix", "must have finite entries");
            Check.that(orientation(row0, row1, row2) != 0, "matrix", "must have an inverse: it makes everything flat");
        }
    }

    private Transform(List<Step> steps) {
        this(steps, new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}, ExactPoint.ORIGIN, matrices(List.copyOf(steps)));
    }

    /**
     * The steps of a transform and some more.
     *
     * @param steps all of them
     * @param rows the linear part of the first steps
     * @param offset where these take the origin
     * @param more the matrices of the other steps
     */
    private Transform(List<Step> steps, Vec3[] rows, ExactPoint offset, List<Matrix> more) {
        this.steps = List.copyOf(steps);
        Vec3[] r = rows;
        ExactPoint d = offset;
        for (Matrix m : more) {
            d = moved(m, d);
            r = new Vec3[] {
                times(m.row0(), r[0], r[1], r[2]), times(m.row1(), r[0], r[1], r[2]), times(m.row2(), r[0], r[1], r[2])
            };
        }
        Check.that(
                r[0].isFinite() && r[1].isFinite() && r[2].isFinite() && orientation(r[0], r[1], r[2]) != 0,
                "transform",
                "must have an inverse in double precision");
        this.offset = d;
        linear =
                new double[] {r[0].x(), r[0].y(), r[0].z(), r[1].x(), r[1].y(), r[1].z(), r[2].x(), r[2].y(), r[2].z()};
    }

    private Vec3[] rows() {
        return new Vec3[] {row(0), row(1), row(2)};
    }

    /** The determinant of these rows, each times a power of two: its sign does not depend on the unit of length. */
    private static double orientation(Vec3 a, Vec3 b, Vec3 c) {
        Vec3 p = a.scaledBy(-a.exponent());
        Vec3 q = b.scaledBy(-b.exponent());
        Vec3 r = c.scaledBy(-c.exponent());
        return p.cross(q).dot(r);
    }

    /**
     * The transform of these steps, applied first to last.
     *
     * @throws enlightenment.math.InvalidValueException (key {@code transform}) if together they have no inverse in double precision
     */
    public static Transform of(Step... steps) {
        return new Transform(List.of(steps));
    }

    /** See {@link #of(Step...)}. */
    public static Transform of(List<Step> steps) {
        return new Transform(steps);
    }

    /** This transform, then another. */
    public Transform then(Transform next) {
        if (next.steps.isEmpty()) {
            return this;
        }
        List<Step> all = new ArrayList<>(steps);
        all.addAll(next.steps);
        return new Transform(all, rows(), offset, next.matrices());
    }

    /** Threads may make them twice, of the same numbers. */
    private List<Matrix> matrices() {
        List<Matrix> made = matrices;
        if (made == null) {
            made = matrices(steps);
            matrices = made;
        }
        return made;
    }

    private static List<Matrix> matrices(List<Step> steps) {
        return steps.stream().map(Transform::matrix).toList();
    }

    private static Matrix matrix(Step step) {
        if (step instanceof Matrix m) {
            return m;
        } else if (step instanceof Scale s) {
            Vec3 f = s.factors();
            return new Matrix(new Vec3(f.x(), 0, 0), new Vec3(0, f.y(), 0), new Vec3(0, 0, f.z()), ExactPoint.ORIGIN);
        } else if (step instanceof Rotate r) {
            return matrix(Rotation.ofDegrees(r.degrees()));
        } else if (step instanceof RotateAbout r) {
            return matrix(Rotation.about(r.axis(), r.degrees()));
        } else if (step instanceof Translate t) {
            return new Matrix(Vec3.X, Vec3.Y, Vec3.Z, t.offset());
        }
        throw new AssertionError("no matrix of " + step);
    }

    private static Matrix matrix(Rotation r) {
        return new Matrix(r.r0(), r.r1(), r.r2(), ExactPoint.ORIGIN);
    }

    /** A row times the matrix of these rows. */
    private static Vec3 times(Vec3 row, Vec3 a, Vec3 b, Vec3 c) {
        return new Vec3(
                row.dot(new Vec3(a.x(), b.x(), c.x())),
                row.dot(new Vec3(a.y(), b.y(), c.y())),
                row.dot(new Vec3(a.z(), b.z(), c.z())));
    }

    private static ExactPoint moved(Matrix m, ExactPoint p) {
        if (m.row0().equals(Vec3.X) && m.row1().equals(Vec3.Y) && m.row2().equals(Vec3.Z)) {
            return p.equals(ExactPoint.ORIGIN) ? m.offset() : sum(p.x(), p.y(), p.z(), m.offset());
        }
        if (p.equals(ExactPoint.ORIGIN)) {
            return m.offset();
        }
        return sum(product(m.row0(), p), product(m.row1(), p), product(m.row2(), p), m.offset());
    }

    private static ExactPoint sum(BigDecimal x, BigDecimal y, BigDecimal z, ExactPoint o) {
        return new ExactPoint(x.add(o.x()), y.add(o.y()), z.add(o.z()));
    }

    private static BigDecimal product(Vec3 row, ExactPoint p) {
        return new BigDecimal(row.x())
                .multiply(p.x())
                .add(new BigDecimal(row.y()).multiply(p.y()))
                .add(new BigDecimal(row.z()).multiply(p.z()))
                .round(DIGITS);
    }

    /** The steps. */
    public List<Step> steps() {
        return steps;
    }

    /** A row of the linear part: 0, 1 or 2. */
    public Vec3 row(int k) {
        return new Vec3(linear[3 * k], linear[3 * k + 1], linear[3 * k + 2]);
    }

    /** Whether it mirrors: a right hand becomes a left one. */
    public boolean isMirror() {
        return orientation(row(0), row(1), row(2)) < 0;
    }

    /** Whether each axis goes to an axis: moved, scaled, mirrored and turned by quarters of a turn at most. */
    boolean keepsAxes() {
        for (Vec3 row : rows()) {
            if ((row.x() == 0 ? 0 : 1) + (row.y() == 0 ? 0 : 1) + (row.z() == 0 ? 0 : 1) != 1) {
                return false;
            }
        }
        return true;
    }

    /** Where the origin goes. */
    public ExactPoint offset() {
        return offset;
    }

    /** The linear part times a vector, rounded. */
    public Vec3 applyLinear(Vec3 v) {
        return new Vec3(row(0).dot(v), row(1).dot(v), row(2).dot(v));
    }

    /** Where a point goes: the linear part is rounded, the offset is added exactly. */
    public ExactPoint apply(Vec3 v) {
        return offset.plus(applyLinear(v));
    }

    /** Where an exact point goes: exactly where the linear part is the identity, else kept to 60 digits. */
    public ExactPoint apply(ExactPoint p) {
        return moved(new Matrix(row(0), row(1), row(2), offset), p);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Transform o && steps.equals(o.steps);
    }

    @Override
    public int hashCode() {
        return steps.hashCode();
    }

    @Override
    public String toString() {
        return "Transform" + steps;
    }
}

package enlightenment.primitive;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Transform;
import enlightenment.math.Vec3;
import enlightenment.mesh.tree.PlacedVertices;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;
import java.util.Arrays;

/**
 * An affine map p = M·q + d from the coordinates of a mesh to the frame, and its inverse. Directions are mapped without normalising, so that
 * the t of a ray is the same number on both sides. Powers of two commute with it.
 */
final class Placing implements PlacedVertices {
    /** The placing that changes nothing. */
    static final Placing IDENTITY = new Placing(Vec3.X, Vec3.Y, Vec3.Z, Vec3.ZERO);

    /** Where the rows of the inverse begin in {@link #numbers}. */
    private static final int INVERSE = 12;

    /** The offset, the rows of M and those of its inverse: flat, since there may be a million placings. */
    private final double[] numbers;

    /** Whether M is the identity. */
    final boolean isMove;

    private Placing(Vec3 m0, Vec3 m1, Vec3 m2, Vec3 offset) {
        isMove = m0.equals(Vec3.X) && m1.equals(Vec3.Y) && m2.equals(Vec3.Z);
        if (isMove) {
            numbers = flat(offset, m0, m1, m2, m0, m1, m2);
            return;
        }
        // The adjugate over the determinant; powers of two are taken out first, so that no product leaves the range of
        // doubles.
        int e = Math.max(m0.exponent(), Math.max(m1.exponent(), m2.exponent()));
        Vec3 a = m0.scaledBy(-e);
        Vec3 b = m1.scaledBy(-e);
        Vec3 c = m2.scaledBy(-e);
        Vec3 x = cross(b, c);
        Vec3 y = cross(c, a);
        Vec3 z = cross(a, b);
        double determinant = Products.accurateDot(a.x(), a.y(), a.z(), x.x(), x.y(), x.z());
        numbers = flat(
                offset,
                m0,
                m1,
                m2,
                quotient(x.x(), y.x(), z.x(), determinant, e),
                quotient(x.y(), y.y(), z.y(), determinant, e),
                quotient(x.z(), y.z(), z.z(), determinant, e));
    }

    private static double[] flat(Vec3... rows) {
        double[] all = new double[3 * rows.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = rows[i / 3].component(i % 3);
        }
        return all;
    }

    private static Vec3 quotient(double x, double y, double z, double determinant, int exponent) {
        return new Vec3(x / determinant, y / determinant, z / determinant).scaledBy(-exponent);
    }

    private static Vec3 cross(Vec3 a, Vec3 b) {
        return new Vec3(
                Products.difference(a.y(), b.z(), a.z(), b.y()),
                Products.difference(a.z(), b.x(), a.x(), b.z()),
                Products.difference(a.x(), b.y(), a.y(), b.x()));
    }

    static Placing of(Transform transform, SceneFrame frame) {
        int e = -frame.exponent();
        return new Placing(
                transform.row(0).scaledBy(e),
                transform.row(1).scaledBy(e),
                transform.row(2).scaledBy(e),
                frame.toFrame(transform.offset()));
    }

    /** This placing into a frame whose unit is smaller by 2^k. */
    Placing scaledBy(int k) {
        return new Placing(row(3).scaledBy(k), row(6).scaledBy(k), row(9).scaledBy(k), row(0).scaledBy(k));
    }

    private Vec3 row(int at) {
        return new Vec3(numbers[at], numbers[at + 1], numbers[at + 2]);
    }

    private double dot(int at, double x, double y, double z) {
        return Products.dot(numbers[at], numbers[at + 1], numbers[at + 2], x, y, z);
    }

    /** Whether each axis of the mesh is mapped to the same axis of the frame. */
    boolean keepsAxes() {
        for (int k = 3; k < INVERSE; k++) {
            if (numbers[k] != 0 && (k - 3) % 4 != 0) {
                return false;
            }
        }
        return true;
    }

    /** The image of the mesh's origin, on an axis. */
    double offset(int axis) {
        return numbers[axis];
    }

    /** The largest absolute coordinate of the image of the mesh's origin. */
    double maxOffset() {
        return Math.max(Math.abs(numbers[0]), Math.max(Math.abs(numbers[1]), Math.abs(numbers[2])));
    }

    /** The image of a point of the mesh. */
    Vec3 point(double x, double y, double z) {
        return new Vec3(coordinate(0, x, y, z), coordinate(1, x, y, z), coordinate(2, x, y, z));
    }

    @Override
    public double coordinate(int axis, double x, double y, double z) {
        return numbers[axis] + dot(3 + 3 * axis, x, y, z);
    }

    /** The least coordinate of a placed box, given by its corners; the greatest one if the corners are exchanged. */
    double least(int axis, double x0, double y0, double z0, double x1, double y1, double z1) {
        int at = 3 + 3 * axis;
        return coordinate(
                axis, numbers[at] < 0 ? x1 : x0, numbers[at + 1] < 0 ? y1 : y0, numbers[at + 2] < 0 ? z1 : z0);
    }

    /** The image of a vector of the mesh. */
    Vec3 vector(Vec3 v) {
        return isMove
                ? v
                : new Vec3(dot(3, v.x(), v.y(), v.z()), dot(6, v.x(), v.y(), v.z()), dot(9, v.x(), v.y(), v.z()));
    }

    /** A vector of the frame in the mesh's coordinates: axis 0, 1 or 2 of M⁻¹·v. */
    double local(int axis, double x, double y, double z) {
        return dot(INVERSE + 3 * axis, x, y, z);
    }

    /** The image of a normal of the mesh, of any length: M⁻ᵀ·n. */
    Vec3 normal(double x, double y, double z) {
        return new Vec3(column(0, x, y, z), column(1, x, y, z), column(2, x, y, z));
    }

    private double column(int axis, double x, double y, double z) {
        int at = INVERSE + axis;
        return Products.dot(numbers[at], numbers[at + 3], numbers[at + 6], x, y, z);
    }

    /** An upper bound of a unit length of the frame in the mesh's coordinates: the largest sum of absolute values in a row of M⁻¹. */
    double largestInverse() {
        return Math.max(sum(INVERSE), Math.max(sum(INVERSE + 3), sum(INVERSE + 6)));
    }

    /** Bounds the error of a placed point, by axis, for points up to a size in the mesh's coordinates. */
    Vec3 slack(double size) {
        double g = Scale.gamma(8);
        return new Vec3(
                g * (sum(3) * size + Math.abs(numbers[0])),
                g * (sum(6) * size + Math.abs(numbers[1])),
                g * (sum(9) * size + Math.abs(numbers[2])));
    }

    private double sum(int at) {
        return Math.abs(numbers[at]) + Math.abs(numbers[at + 1]) + Math.abs(numbers[at + 2]);
    }

    /** The factor of volumes, positive. */
    double volumeFactor() {
        return Math.abs(determinant());
    }

    private double determinant() {
        return row(3).cross(row(6)).dot(row(9));
    }

    @Override
    public boolean isMirror() {
        return determinant() < 0;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Placing o && Arrays.equals(numbers, o.numbers);
    }

    @Override
    public int hashCode() {
        int hash = 1;
        // The inverse is given by the other numbers.
        for (int k = 0; k < INVERSE; k++) {
            hash = 31 * hash + Double.hashCode(numbers[k]);
        }
        return hash;
    }

    /** The numbers for code on another device: offset, matrix and inverse, whether it is a translation, and two bounds. */
    double[] flatForm() {
        double[] all = Arrays.copyOf(numbers, numbers.length + 3);
        all[numbers.length] = isMove ? 1 : 0;
        all[numbers.length + 1] = maxOffset();
        all[numbers.length + 2] = largestInverse();
        return all;
    }

    /** The offset, then the matrix. */
    double[] numbers() {
        return Arrays.copyOf(numbers, INVERSE);
    }
}

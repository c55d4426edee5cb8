package enlightenment.primitive;

import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Transform;
import enlightenment.math.Vec3;
import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * An affine map p = M·q + d from the coordinates of a mesh to the frame, and its inverse. Directions are mapped without normalising, so that
 * the t of a ray is the same number on both sides. Powers of two commute with it.
 */
final class Placing {
    private final Vec3 m0;
    private final Vec3 m1;
    private final Vec3 m2;
    final Vec3 offset;
    private final Vec3 inverse0;
    private final Vec3 inverse1;
    private final Vec3 inverse2;

    /** Whether M is the identity. */
    final boolean isMove;

    private Placing(Vec3 m0, Vec3 m1, Vec3 m2, Vec3 offset) {
        this.m0 = m0;
        this.m1 = m1;
        this.m2 = m2;
        this.offset = offset;
        isMove = m0.equals(Vec3.X) && m1.equals(Vec3.Y) && m2.equals(Vec3.Z);
        if (isMove) {
            inverse0 = m0;
            inverse1 = m1;
            inverse2 = m2;
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
        inverse0 = quotient(x.x(), y.x(), z.x(), determinant, e);
        inverse1 = quotient(x.y(), y.y(), z.y(), determinant, e);
        inverse2 = quotient(x.z(), y.z(), z.z(), determinant, e);
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
        return new Placing(m0.scaledBy(k), m1.scaledBy(k), m2.scaledBy(k), offset.scaledBy(k));
    }

    /** Where a point of the mesh is. */
    Vec3 point(double x, double y, double z) {
        return new Vec3(
                offset.x() + Products.dot(m0.x(), m0.y(), m0.z(), x, y, z),
                offset.y() + Products.dot(m1.x(), m1.y(), m1.z(), x, y, z),
                offset.z() + Products.dot(m2.x(), m2.y(), m2.z(), x, y, z));
    }

    /** A coordinate of where a point of the mesh is. */
    double coordinate(int axis, double x, double y, double z) {
        Vec3 row = axis == 0 ? m0 : axis == 1 ? m1 : m2;
        return offset.component(axis) + Products.dot(row.x(), row.y(), row.z(), x, y, z);
    }

    /** The half extent of a placed box. */
    double extent(int axis, double hx, double hy, double hz) {
        Vec3 row = axis == 0 ? m0 : axis == 1 ? m1 : m2;
        return Math.abs(row.x()) * hx + Math.abs(row.y()) * hy + Math.abs(row.z()) * hz;
    }

    /** A vector of the mesh in the frame. */
    Vec3 vector(Vec3 v) {
        return isMove
                ? v
                : new Vec3(
                        Products.dot(m0.x(), m0.y(), m0.z(), v.x(), v.y(), v.z()),
                        Products.dot(m1.x(), m1.y(), m1.z(), v.x(), v.y(), v.z()),
                        Products.dot(m2.x(), m2.y(), m2.z(), v.x(), v.y(), v.z()));
    }

    /** A vector of the frame as the mesh has it: axis 0, 1 or 2 of M⁻¹·v. */
    double local(int axis, double x, double y, double z) {
        Vec3 r = axis == 0 ? inverse0 : axis == 1 ? inverse1 : inverse2;
        return Products.dot(r.x(), r.y(), r.z(), x, y, z);
    }

    /** A normal of the mesh in the frame, of any length: M⁻ᵀ·n. */
    Vec3 normal(double x, double y, double z) {
        return new Vec3(
                Products.dot(inverse0.x(), inverse1.x(), inverse2.x(), x, y, z),
                Products.dot(inverse0.y(), inverse1.y(), inverse2.y(), x, y, z),
                Products.dot(inverse0.z(), inverse1.z(), inverse2.z(), x, y, z));
    }

    /** What a length of the frame is in the mesh at most: the largest sum of absolute values in a row of M⁻¹. */
    double largestInverse() {
        return Math.max(sum(inverse0), Math.max(sum(inverse1), sum(inverse2)));
    }

    /** Bounds how far the placed point is off, by axis, for points up to a size in the mesh's coordinates. */
    Vec3 slack(double size) {
        double g = Scale.gamma(8);
        return new Vec3(
                g * (sum(m0) * size + Math.abs(offset.x())),
                g * (sum(m1) * size + Math.abs(offset.y())),
                g * (sum(m2) * size + Math.abs(offset.z())));
    }

    private static double sum(Vec3 v) {
        return Math.abs(v.x()) + Math.abs(v.y()) + Math.abs(v.z());
    }

    /** The factor of volumes, positive. */
    double volumeFactor() {
        return Math.abs(m0.cross(m1).dot(m2));
    }

    /** Its numbers: where it puts the origin, then the matrix. */
    double[] numbers() {
        return new double[] {
            offset.x(), offset.y(), offset.z(), m0.x(), m0.y(), m0.z(), m1.x(), m1.y(), m1.z(), m2.x(), m2.y(), m2.z()
        };
    }
}

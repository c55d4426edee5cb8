package enlightenment.math;

import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * An immutable triple of doubles: a direction, an offset or a position in a frame that has already been chosen.
 *
 * <p>Positions in a scene description are {@link ExactPoint}s, which are exact.
 *
 * @param x first component
 * @param y second component (up, in the paper's scenes)
 * @param z third component (away from the viewer, in the paper's scenes)
 */
public record Vec3(double x, double y, double z) {
    public static final Vec3 ZERO = new Vec3(0, 0, 0);
    public static final Vec3 X = new Vec3(1, 0, 0);
    public static final Vec3 Y = new Vec3(0, 1, 0);
    public static final Vec3 Z = new Vec3(0, 0, 1);

    public static Vec3 of(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    public Vec3 plus(Vec3 o) {
        return new Vec3(x + o.x, y + o.y, z + o.z);
    }

    public Vec3 minus(Vec3 o) {
        return new Vec3(x - o.x, y - o.y, z - o.z);
    }

    public Vec3 times(double s) {
        return new Vec3(x * s, y * s, z * s);
    }

    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    /** The dot product, with one rounding fewer than the plain sum. */
    public double dot(Vec3 o) {
        return Products.dot(x, y, z, o.x, o.y, o.z);
    }

    /** The cross product; each component is right to 1.5 units in the last place ({@link Products#difference}). */
    public Vec3 cross(Vec3 o) {
        return new Vec3(
                Products.difference(y, o.z, z, o.y),
                Products.difference(z, o.x, x, o.z),
                Products.difference(x, o.y, y, o.x));
    }

    public double lengthSquared() {
        return dot(this);
    }

    /** The Euclidean length; does not overflow or underflow before the result does. */
    public double length() {
        int e = exponent();
        if (e == Scale.ZERO_EXPONENT) {
            return 0;
        }
        Vec3 v = scaledBy(-e);
        return Math.scalb(Math.sqrt(v.lengthSquared()), e);
    }

    /** This vector with length 1; the zero vector has no direction and is refused. */
    public Vec3 normalized() {
        int e = exponent();
        if (e == Scale.ZERO_EXPONENT) {
            throw new ArithmeticException("the zero vector has no direction");
        }
        Vec3 v = scaledBy(-e);
        return v.times(1 / Math.sqrt(v.lengthSquared()));
    }

    /** This vector times 2^k, exact unless a component leaves the range of doubles. */
    public Vec3 scaledBy(int k) {
        return new Vec3(Scale.scalb(x, k), Scale.scalb(y, k), Scale.scalb(z, k));
    }

    /** Exponent e with 2^e at most the largest |component| &lt; 2^(e+1), or {@link Scale#ZERO_EXPONENT}. */
    public int exponent() {
        return Scale.exponent(maxAbs());
    }

    /** The largest absolute component. */
    public double maxAbs() {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }

    /** Component 0, 1 or 2. */
    public double component(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }
}

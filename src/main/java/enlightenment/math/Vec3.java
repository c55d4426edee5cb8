package enlightenment.math;

import enlightenment.numeric.Products;
import enlightenment.numeric.Scale;

/**
 * An immutable triple of doubles: a direction or an offset. Positions in a scene description are {@link ExactPoint}s.
 *
 * <p>Components may be any doubles, infinities and NaN included; what takes a vector says what it accepts. Operations round
 * each component once unless they say otherwise, and give infinities or NaN where the result leaves the range of doubles.
 *
 * @param x first component
 * @param y second component (up, in the paper's scenes)
 * @param z third component (away from the viewer, in the paper's scenes)
 */
public record Vec3(double x, double y, double z) {
    /** The zero vector. */
    public static final Vec3 ZERO = new Vec3(0, 0, 0);

    /** The unit vector along the first axis. */
    public static final Vec3 X = new Vec3(1, 0, 0);

    /** The unit vector along the second axis. */
    public static final Vec3 Y = new Vec3(0, 1, 0);

    /** The unit vector along the third axis. */
    public static final Vec3 Z = new Vec3(0, 0, 1);

    /** The vector with these components. */
    public static Vec3 of(double x, double y, double z) {
        return new Vec3(x, y, z);
    }

    /** The sum of this vector and o. */
    public Vec3 plus(Vec3 o) {
        return new Vec3(x + o.x, y + o.y, z + o.z);
    }

    /** This vector minus o. */
    public Vec3 minus(Vec3 o) {
        return new Vec3(x - o.x, y - o.y, z - o.z);
    }

    /** This vector with every component times s. */
    public Vec3 times(double s) {
        return new Vec3(x * s, y * s, z * s);
    }

    /** The vector of the same length in the opposite direction. */
    public Vec3 negated() {
        return new Vec3(-x, -y, -z);
    }

    /** The dot product, with fused steps: error at most three roundings of the sum of the absolute products. */
    public double dot(Vec3 o) {
        return Products.dot(x, y, z, o.x, o.y, o.z);
    }

    /** The cross product; each component is accurate to 1.5 units in the last place, however much of it cancels. */
    public Vec3 cross(Vec3 o) {
        return new Vec3(
                Products.difference(y, o.z, z, o.y),
                Products.difference(z, o.x, x, o.z),
                Products.difference(x, o.y, y, o.x));
    }

    /** The squared Euclidean length; overflows or underflows where the square does. */
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

    /**
     * This vector with length 1, however long or short it is.
     *
     * @throws ArithmeticException for the zero vector, which has no direction
     */
    public Vec3 normalized() {
        int e = exponent();
        if (e == Scale.ZERO_EXPONENT) {
            throw new ArithmeticException("the zero vector has no direction");
        }
        Vec3 v = scaledBy(-e);
        return v.times(1 / Math.sqrt(v.lengthSquared()));
    }

    /** This vector times 2^k, exact unless a component leaves the range of normal doubles. */
    public Vec3 scaledBy(int k) {
        return new Vec3(Scale.scalb(x, k), Scale.scalb(y, k), Scale.scalb(z, k));
    }

    /** The e for which the largest absolute component is in [2^e, 2^(e+1)); -2000 for the zero vector. */
    public int exponent() {
        return Scale.exponent(maxAbs());
    }

    /** The largest absolute component. */
    public double maxAbs() {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** Whether no component is infinite or NaN. */
    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
    }

    /** A component by its axis: 0 for x, 1 for y, anything else for z. */
    public double component(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }
}

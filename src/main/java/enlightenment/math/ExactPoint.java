package enlightenment.math;

import enlightenment.numeric.Decimals;
import java.math.BigDecimal;
import java.util.Objects;

/**
 * An exact position in a scene description.
 *
 * <p>Coordinates are kept as the decimals that were written, because the picture must not depend on where the scene's
 * origin lies: the compiler subtracts the eye exactly and rounds once (docs/numerics.md, "exact frame").
 *
 * <p>Points are equal if their coordinates are equal numbers, however these were written.
 *
 * @param x exact first coordinate, in scene units; stored without trailing zeros
 * @param y exact second coordinate
 * @param z exact third coordinate
 */
public record ExactPoint(BigDecimal x, BigDecimal y, BigDecimal z) {
    /** The origin of the scene's coordinates. */
    public static final ExactPoint ORIGIN = new ExactPoint(BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO);

    /** Beyond this binary exponent, components of a difference may have lost digits to the limits of doubles. */
    private static final int ORDINARY_EXPONENT = 900;

    /**
     * If the cross product of two directions exceeds this share of the product of their lengths, it is not zero: the roundings
     * of the directions and of the products are below 2^-50 of that product.
     */
    private static final double CERTAINLY_NOT_ZERO = 0x1p-40;

    /** Whole numbers of fewer digits are kept without an exponent. */
    private static final int SHORT = 9;

    /**
     * The point with these coordinates.
     *
     * @throws NullPointerException if one is missing
     */
    public ExactPoint {
        x = canonical(x);
        y = canonical(y);
        z = canonical(z);
    }

    private static BigDecimal canonical(BigDecimal v) {
        Objects.requireNonNull(v, "coordinate");
        if (v.signum() == 0) {
            return BigDecimal.ZERO;
        }
        if (v.scale() == 0 && v.precision() < SHORT) {
            return v;
        }
        BigDecimal s = v.stripTrailingZeros();
        // Equal numbers must become equal objects: 100.0 is stripped to 1E+2, which does not equal 100.
        return s.scale() < 0 && (long) s.precision() - s.scale() < SHORT ? s.setScale(0) : s;
    }

    /**
     * The point with exactly these coordinates: 0.1 means the double nearest to a tenth, not a tenth.
     *
     * @throws InvalidValueException (key {@code x}, {@code y} or {@code z}) for a coordinate that is infinite or NaN
     */
    public static ExactPoint of(double x, double y, double z) {
        requireFinite("x", x);
        requireFinite("y", y);
        requireFinite("z", z);
        return new ExactPoint(exact(x), exact(y), exact(z));
    }

    /**
     * The point with these decimal coordinates, exactly as written.
     *
     * @throws NumberFormatException for a text that {@link BigDecimal#BigDecimal(String)} refuses
     */
    public static ExactPoint of(String x, String y, String z) {
        return new ExactPoint(new BigDecimal(x), new BigDecimal(y), new BigDecimal(z));
    }

    private static BigDecimal exact(double v) {
        if (!Double.isFinite(v)) {
            throw new IllegalArgumentException("a coordinate must be finite, not " + v);
        }
        return new BigDecimal(v);
    }

    /**
     * This point moved by exactly d.
     *
     * @throws IllegalArgumentException if d is not finite
     */
    public ExactPoint plus(Vec3 d) {
        return new ExactPoint(x.add(exact(d.x())), y.add(exact(d.y())), z.add(exact(d.z())));
    }

    /** The offset from o to this point, computed exactly and rounded once per component; infinite beyond the range of doubles. */
    public Vec3 minus(ExactPoint o) {
        return new Vec3(
                x.subtract(o.x).doubleValue(),
                y.subtract(o.y).doubleValue(),
                z.subtract(o.z).doubleValue());
    }

    /**
     * The direction from this point to another. Its length says nothing: it is the difference times some power of two, so that
     * it is accurate to rounding even where the difference is beyond the range of doubles. Zero if and only if the two points
     * are equal.
     */
    public Vec3 directionTo(ExactPoint o) {
        Vec3 d = o.minus(this);
        int e = d.exponent();
        if (Math.abs(e) < ORDINARY_EXPONENT && d.isFinite()) {
            return d.scaledBy(-e);
        }
        return direction(o.x.subtract(x), o.y.subtract(y), o.z.subtract(z));
    }

    /** An estimate of the binary exponent of the largest component of the difference to another point, off by a few at most. */
    public int exponentTo(ExactPoint o) {
        Vec3 d = o.minus(this);
        int e = d.exponent();
        if (Math.abs(e) < ORDINARY_EXPONENT && d.isFinite()) {
            return e;
        }
        return Math.max(
                Decimals.exponent(o.x.subtract(x)),
                Math.max(Decimals.exponent(o.y.subtract(y)), Decimals.exponent(o.z.subtract(z))));
    }

    /** Whether three points lie exactly on one line, or some of them coincide. A sliver, however thin, is not a line. */
    public static boolean areCollinear(ExactPoint a, ExactPoint b, ExactPoint c) {
        Vec3 p = a.directionTo(b);
        Vec3 q = a.directionTo(c);
        return !(p.cross(q).length() > p.length() * q.length() * CERTAINLY_NOT_ZERO)
                && normal(a, b, c).maxAbs() == 0;
    }

    /**
     * The direction of (b − a) × (c − a), the normal of a triangle, accurate to rounding however thin the triangle is. Its length
     * says nothing. Zero if and only if the points are collinear.
     */
    public static Vec3 normal(ExactPoint a, ExactPoint b, ExactPoint c) {
        BigDecimal[] n = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            int i = (k + 1) % 3;
            int j = (k + 2) % 3;
            BigDecimal left = difference(a, b, i).multiply(difference(a, c, j));
            n[k] = left.subtract(difference(a, b, j).multiply(difference(a, c, i)));
        }
        return direction(n[0], n[1], n[2]);
    }

    private static BigDecimal difference(ExactPoint from, ExactPoint to, int axis) {
        return to.component(axis).subtract(from.component(axis));
    }

    /** The coordinates, each rounded to the nearest double. */
    public Vec3 toVec3() {
        return new Vec3(x.doubleValue(), y.doubleValue(), z.doubleValue());
    }

    /** A coordinate by its axis: 0 for x, 1 for y, anything else for z. */
    public BigDecimal component(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    private static void requireFinite(String key, double v) {
        if (!Double.isFinite(v)) {
            throw new InvalidValueException(key, "must be a finite number, not " + v);
        }
    }

    /** Three numbers times some power of two, as a vector: accurate to rounding, however large or small they are. */
    private static Vec3 direction(BigDecimal x, BigDecimal y, BigDecimal z) {
        int e = Math.max(Decimals.exponent(x), Math.max(Decimals.exponent(y), Decimals.exponent(z)));
        if (e == Integer.MIN_VALUE) {
            return Vec3.ZERO;
        }
        return new Vec3(
                Decimals.timesPowerOfTwo(x, -e).doubleValue(),
                Decimals.timesPowerOfTwo(y, -e).doubleValue(),
                Decimals.timesPowerOfTwo(z, -e).doubleValue());
    }
}

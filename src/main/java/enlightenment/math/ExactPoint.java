package enlightenment.math;

import enlightenment.numeric.Decimals;
import java.math.BigDecimal;
import java.util.Arrays;

/**
 * A position in a scene: three coordinates, exactly the decimals that were written.
 *
 * <p>Coordinates are kept as the decimals that were written, because the picture must not depend on where the scene's
 * origin lies: the compiler subtracts the eye exactly and rounds once (docs/notes/numerics.md, "exact frame").
 *
 * <p>Points are equal if their coordinates are equal numbers, however these were written.
 *
 * <p>A coordinate of up to 17 digits is kept in 8 bytes, because a scene may have a million points. What is equal is kept
 * equally.
 *
 * <p>Immutable.
 *
 */
public final class ExactPoint {
    /** Beyond this binary exponent, components of a difference may have lost digits to the limits of doubles. */
    private static final int ORDINARY_EXPONENT = 900;

    /**
     * If the cross product of two directions exceeds this share of the product of their lengths, it is not zero: the roundings
     * of the directions and of the products are below 2^-50 of that product.
     */
    private static final double CERTAINLY_NOT_ZERO = 0x1p-40;

    /**
     * The largest decimal exponent of a coordinate, far beyond what scene files may say and what a picture needs. A number of a few
     * characters can have a billion digits.
     */
    private static final int LARGEST_EXPONENT = 10_000;

    /** The origin of the scene's coordinates. */
    public static final ExactPoint ORIGIN = new ExactPoint(BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO);

    /** The coordinates as {@link ShortDecimal}s; {@link ShortDecimal#NONE} where one has too many digits. */
    private final long x;

    private final long y;
    private final long z;

    /** By axis, the coordinates that have too many digits; null where none has. */
    private final BigDecimal[] exact;

    /**
     * The point with these coordinates.
     *
     * @param x exact first coordinate, in scene units; kept without trailing zeros
     * @param y exact second coordinate
     * @param z exact third coordinate
     * @throws NullPointerException if one is missing
     * @throws InvalidValueException (key {@code x}, {@code y} or {@code z}) for one other than 0 that is not between 10^-10000 and
     *     10^10000 in size: differences and products of others may have more digits than a machine holds
     */
    public ExactPoint(BigDecimal x, BigDecimal y, BigDecimal z) {
        this.x = ShortDecimal.of(x);
        this.y = ShortDecimal.of(y);
        this.z = ShortDecimal.of(z);
        boolean all = this.x != ShortDecimal.NONE && this.y != ShortDecimal.NONE && this.z != ShortDecimal.NONE;
        exact = all
                ? null
                : new BigDecimal[] {longOne("x", this.x, x), longOne("y", this.y, y), longOne("z", this.z, z)};
    }

    private ExactPoint(long x, long y, long z) {
        this.x = x;
        this.y = y;
        this.z = z;
        exact = null;
    }

    private static BigDecimal longOne(String key, long form, BigDecimal v) {
        if (form != ShortDecimal.NONE) {
            return null;
        }
        BigDecimal s = v.stripTrailingZeros();
        long exponent = (long) s.precision() - s.scale() - 1;
        if (exponent < -LARGEST_EXPONENT || exponent >= LARGEST_EXPONENT) {
            throw new InvalidValueException(
                    key,
                    "must be 0 or between 1e-" + LARGEST_EXPONENT + " and 1e" + LARGEST_EXPONENT
                            + " in size, not about 1e" + exponent);
        }
        return s;
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
     * @throws InvalidValueException as of {@link #ExactPoint(BigDecimal, BigDecimal, BigDecimal)}
     */
    public static ExactPoint of(String x, String y, String z) {
        long p = ShortDecimal.of(x);
        long q = ShortDecimal.of(y);
        long r = ShortDecimal.of(z);
        return p != ShortDecimal.NONE && q != ShortDecimal.NONE && r != ShortDecimal.NONE
                ? new ExactPoint(p, q, r)
                : new ExactPoint(new BigDecimal(x), new BigDecimal(y), new BigDecimal(z));
    }

    private static BigDecimal exact(double v) {
        if (!Double.isFinite(v)) {
            throw new IllegalArgumentException("a coordinate must be finite, not " + v);
        }
        return new BigDecimal(v);
    }

    /** The exact first coordinate, without zeros at its end. */
    public BigDecimal x() {
        return x == ShortDecimal.NONE ? exact[0] : ShortDecimal.value(x);
    }

    /** The exact second coordinate, without zeros at its end. */
    public BigDecimal y() {
        return y == ShortDecimal.NONE ? exact[1] : ShortDecimal.value(y);
    }

    /** The exact third coordinate, without zeros at its end. */
    public BigDecimal z() {
        return z == ShortDecimal.NONE ? exact[2] : ShortDecimal.value(z);
    }

    /**
     * This point moved by exactly d.
     *
     * @throws IllegalArgumentException if d is not finite
     */
    public ExactPoint plus(Vec3 d) {
        return new ExactPoint(x().add(exact(d.x())), y().add(exact(d.y())), z().add(exact(d.z())));
    }

    /** The offset from o to this point, computed exactly and rounded once per component; infinite beyond the range of doubles. */
    public Vec3 minus(ExactPoint o) {
        return new Vec3(difference(x, o.x, o, 0), difference(y, o.y, o, 1), difference(z, o.z, o, 2));
    }

    private double difference(long mine, long other, ExactPoint o, int axis) {
        double d = ShortDecimal.difference(mine, other);
        return Double.isNaN(d) ? Decimals.nearest(component(axis).subtract(o.component(axis))) : d;
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
        return direction(difference(this, o, 0), difference(this, o, 1), difference(this, o, 2));
    }

    /** An estimate of the binary exponent of the largest component of the difference to another point, off by a few at most. */
    public int exponentTo(ExactPoint o) {
        Vec3 d = o.minus(this);
        int e = d.exponent();
        if (Math.abs(e) < ORDINARY_EXPONENT && d.isFinite()) {
            return e;
        }
        return Math.max(
                Decimals.exponent(difference(this, o, 0)),
                Math.max(Decimals.exponent(difference(this, o, 1)), Decimals.exponent(difference(this, o, 2))));
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
        return minus(ORIGIN);
    }

    /** A coordinate by its axis: 0 for x, 1 for y, anything else for z. */
    public BigDecimal component(int axis) {
        return axis == 0 ? x() : axis == 1 ? y() : z();
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

    @Override
    public boolean equals(Object other) {
        return other instanceof ExactPoint o && x == o.x && y == o.y && z == o.z && Arrays.equals(exact, o.exact);
    }

    @Override
    public int hashCode() {
        int h = 31 * Long.hashCode(x) + Long.hashCode(y);
        return 31 * (31 * h + Long.hashCode(z)) + Arrays.hashCode(exact);
    }

    @Override
    public String toString() {
        return "ExactPoint[x=" + x() + ", y=" + y() + ", z=" + z() + "]";
    }
}

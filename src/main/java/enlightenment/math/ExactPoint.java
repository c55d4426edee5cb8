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
 * @param x exact first coordinate, trailing zeros stripped
 * @param y exact second coordinate
 * @param z exact third coordinate
 */
public record ExactPoint(BigDecimal x, BigDecimal y, BigDecimal z) {
    public static final ExactPoint ORIGIN = new ExactPoint(BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO);

    /** Beyond this binary exponent, components of a difference may have lost digits to the limits of doubles. */
    private static final int ORDINARY_EXPONENT = 900;

    /**
     * A cross product of two directions that is longer than this share of the product of their lengths is one: the roundings
     * of the directions and of the products are below 2^-50 of that product.
     */
    private static final double CERTAIN = 0x1p-40;

    /** Whole numbers of fewer digits are kept without an exponent. */
    private static final int SHORT = 9;

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

    /** The point with exactly these coordinates: 0.1 means the double nearest to a tenth, not a tenth. */
    public static ExactPoint of(double x, double y, double z) {
        requireFinite("x", x);
        requireFinite("y", y);
        requireFinite("z", z);
        return new ExactPoint(exact(x), exact(y), exact(z));
    }

    /** The point with these decimal coordinates, exactly as written. */
    public static ExactPoint of(String x, String y, String z) {
        return new ExactPoint(new BigDecimal(x), new BigDecimal(y), new BigDecimal(z));
    }

    private static BigDecimal exact(double v) {
        if (!Double.isFinite(v)) {
            throw new IllegalArgumentException("a coordinate must be finite, not " + v);
        }
        return new BigDecimal(v);
    }

    /** This point shifted by exactly d. */
    public ExactPoint plus(Vec3 d) {
        return new ExactPoint(x.add(exact(d.x())), y.add(exact(d.y())), z.add(exact(d.z())));
    }

    /** The difference this − o, computed exactly and rounded once per component. */
    public Vec3 minus(ExactPoint o) {
        return new Vec3(
                x.subtract(o.x).doubleValue(),
                y.subtract(o.y).doubleValue(),
                z.subtract(o.z).doubleValue());
    }

    /**
     * The direction from here to another point, of any length that is handy: right to rounding even where the difference is
     * beyond the range of doubles. Zero if and only if the two are the same point.
     */
    public Vec3 directionTo(ExactPoint o) {
        Vec3 d = o.minus(this);
        int e = d.exponent();
        if (Math.abs(e) < ORDINARY_EXPONENT && d.isFinite()) {
            return d.scaledBy(-e);
        }
        return direction(o.x.subtract(x), o.y.subtract(y), o.z.subtract(z));
    }

    /** The binary exponent of the largest component of the difference from here to another point, or one near it. */
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

    /** Whether three points lie exactly in one line. */
    public static boolean inLine(ExactPoint a, ExactPoint b, ExactPoint c) {
        Vec3 p = a.directionTo(b);
        Vec3 q = a.directionTo(c);
        return !(p.cross(q).length() > p.length() * q.length() * CERTAIN)
                && normal(a, b, c).maxAbs() == 0;
    }

    /**
     * The direction (b − a) × (c − a), of any length that is handy; right to rounding however thin the triangle is. Zero if
     * and only if the points lie in one line.
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

    /** The coordinates, each rounded once. */
    public Vec3 toVec3() {
        return new Vec3(x.doubleValue(), y.doubleValue(), z.doubleValue());
    }

    /** Component 0, 1 or 2. */
    public BigDecimal component(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }

    private static void requireFinite(String key, double v) {
        if (!Double.isFinite(v)) {
            throw new InvalidValueException(key, "must be a finite number, not " + v);
        }
    }

    /** Three numbers as a vector of any length that is handy: their ratios are right to rounding, however large they are. */
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

package enlightenment.math;

import java.math.BigDecimal;
import java.util.Objects;

/**
 * An exact position in a scene description.
 *
 * <p>Coordinates are kept as the decimals that were written, because the picture must not depend on where the scene's
 * origin lies: the compiler subtracts the eye exactly and rounds once ({@link SceneFrame}).
 *
 * @param x exact first coordinate, trailing zeros stripped
 * @param y exact second coordinate
 * @param z exact third coordinate
 */
public record Point(BigDecimal x, BigDecimal y, BigDecimal z) {
    public static final Point ORIGIN = new Point(BigDecimal.ZERO, BigDecimal.ZERO, BigDecimal.ZERO);

    /** Whole numbers of fewer digits are kept without an exponent. */
    private static final int SHORT = 9;

    public Point {
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
    public static Point of(double x, double y, double z) {
        Check.finite("x", x);
        Check.finite("y", y);
        Check.finite("z", z);
        return new Point(exact(x), exact(y), exact(z));
    }

    /** The point with these decimal coordinates, exactly as written. */
    public static Point of(String x, String y, String z) {
        return new Point(new BigDecimal(x), new BigDecimal(y), new BigDecimal(z));
    }

    private static BigDecimal exact(double v) {
        if (!Double.isFinite(v)) {
            throw new IllegalArgumentException("a coordinate must be finite, not " + v);
        }
        return new BigDecimal(v);
    }

    /** This point shifted by exactly d. */
    public Point plus(Vec3 d) {
        return new Point(x.add(exact(d.x())), y.add(exact(d.y())), z.add(exact(d.z())));
    }

    /** The difference this − o, computed exactly and rounded once per component. */
    public Vec3 minus(Point o) {
        return new Vec3(
                x.subtract(o.x).doubleValue(),
                y.subtract(o.y).doubleValue(),
                z.subtract(o.z).doubleValue());
    }

    /** The coordinates, each rounded once. */
    public Vec3 toVec3() {
        return new Vec3(x.doubleValue(), y.doubleValue(), z.doubleValue());
    }

    /** Component 0, 1 or 2. */
    public BigDecimal component(int axis) {
        return axis == 0 ? x : axis == 1 ? y : z;
    }
}

package enlightenment.view.camera;

import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Rounding of camera parameters to short decimals, relative to a size, so that the unit of length does not matter. */
public final class Digits {
    /** Significant digits of lengths and angles, and digits of coordinates below the first digit of the reference size. */
    public static final int KEPT = 7;

    private static final MathContext SIGNIFICANT = new MathContext(KEPT, RoundingMode.HALF_EVEN);

    private Digits() {}

    /** A number rounded to {@link #KEPT} significant digits. */
    public static double rounded(double v) {
        return new BigDecimal(v).round(SIGNIFICANT).doubleValue();
    }

    /** A point with coordinates rounded to {@link #KEPT} digits below the first digit of a size. */
    public static ExactPoint rounded(ExactPoint p, double size) {
        int places = places(size);
        return new ExactPoint(
                p.x().setScale(places, RoundingMode.HALF_EVEN),
                p.y().setScale(places, RoundingMode.HALF_EVEN),
                p.z().setScale(places, RoundingMode.HALF_EVEN));
    }

    /** A normalized direction, with rounded components. */
    public static Vec3 direction(Vec3 v) {
        Vec3 unit = v.normalized();
        return rounded(ExactPoint.of(unit.x(), unit.y(), unit.z()), 1).toVec3();
    }

    private static int places(double size) {
        BigDecimal exact = new BigDecimal(size);
        return KEPT - (exact.precision() - exact.scale() - 1);
    }
}

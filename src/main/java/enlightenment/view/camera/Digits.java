package enlightenment.view.camera;

import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Rounds numbers of cameras to decimals that can be read, by ratios: the unit of length has no part in it. */
public final class Digits {
    /** Significant digits of lengths and angles; of coordinates the digits below the size that they are seen at. */
    public static final int KEPT = 7;

    private static final MathContext SIGNIFICANT = new MathContext(KEPT, RoundingMode.HALF_EVEN);

    private Digits() {}

    /** A number with {@link #KEPT} significant digits. */
    public static double rounded(double v) {
        return new BigDecimal(v).round(SIGNIFICANT).doubleValue();
    }

    /** A point whose coordinates end {@link #KEPT} digits below the first digit of a size. */
    public static ExactPoint rounded(ExactPoint p, double size) {
        int places = places(size);
        return new ExactPoint(
                p.x().setScale(places, RoundingMode.HALF_EVEN),
                p.y().setScale(places, RoundingMode.HALF_EVEN),
                p.z().setScale(places, RoundingMode.HALF_EVEN));
    }

    /** A direction of length 1, up to rounding. */
    public static Vec3 direction(Vec3 v) {
        Vec3 unit = v.normalized();
        return rounded(ExactPoint.of(unit.x(), unit.y(), unit.z()), 1).toVec3();
    }

    private static int places(double size) {
        BigDecimal exact = new BigDecimal(size);
        return KEPT - (exact.precision() - exact.scale() - 1);
    }
}

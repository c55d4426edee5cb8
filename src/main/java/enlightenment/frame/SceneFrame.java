package enlightenment.frame;

import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.numeric.Decimals;
import enlightenment.numeric.Scale;
import java.math.BigDecimal;
import java.util.Objects;

/**
 * The frame that a scene is rendered in: an exact origin (the eye) and a power of two.
 *
 * <p>A position p becomes (p − origin)·2^-exponent: the difference is exact, is rounded once, and the power of two is exact. So the
 * compiled numbers, and with them the picture, do not depend on where the scene's origin lies, nor on a unit that differs by a power of two
 * (numerics: "exact frame").
 *
 * @param origin the position that becomes (0, 0, 0)
 * @param exponent e such that lengths are divided by 2^e
 */
public record SceneFrame(ExactPoint origin, int exponent) {
    /** The frame of the scene's own coordinates, which are only rounded. */
    public static final SceneFrame WORLD = new SceneFrame(ExactPoint.ORIGIN, 0);

    /** Beyond this exponent a double is scaled as an exact decimal, so that it is never rounded twice. */
    private static final int SAFE_EXPONENT = 900;

    public SceneFrame {
        Objects.requireNonNull(origin, "origin");
    }

    /** The position of p in this frame, each component rounded once. */
    public Vec3 toFrame(ExactPoint p) {
        Vec3 d = p.minus(origin);
        return new Vec3(component(d.x(), p, 0), component(d.y(), p, 1), component(d.z(), p, 2));
    }

    /** A length (or an offset's component) in this frame. */
    public double toFrame(double length) {
        return Scale.scalb(length, -exponent);
    }

    /** A component in the frame, from that of the difference, rounded. */
    private double component(double rounded, ExactPoint p, int axis) {
        int e = Scale.exponent(rounded);
        if (rounded != 0 && Math.abs(e) < SAFE_EXPONENT && Math.abs(e - exponent) < SAFE_EXPONENT) {
            return Scale.scalb(rounded, -exponent);
        }
        BigDecimal exact = p.component(axis).subtract(origin.component(axis));
        return exact.signum() == 0
                ? 0
                : Decimals.timesPowerOfTwo(exact, -exponent).doubleValue();
    }
}

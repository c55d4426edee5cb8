package enlightenment.numeric;

/**
 * Angles from coordinates, by fused operations only: the same on every machine, and several times as fast as
 * {@link StrictMath#atan2}. For texture coordinates; accurate to 2 units in the last place.
 */
public final class Angles {
    /** tan(π/16) and tan(3π/16) are where the reduction of the argument changes, tan(π/8) is what it subtracts. */
    private static final double TAN_SIXTEENTH = 0.198912367379658;

    private static final double TAN_EIGHTH = 0.41421356237309503;
    private static final double TAN_THREE_SIXTEENTHS = 0.6681786379192989;
    private static final double EIGHTH_OF_PI = Math.PI / 8;
    private static final double QUARTER_OF_PI = Math.PI / 4;
    private static final double HALF_OF_PI = Math.PI / 2;

    private Angles() {}

    /** The angle of the point (x, y) from the x axis towards the y axis, −π..π; 0 for the origin. */
    public static double atan2(double y, double x) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        boolean steep = ay > ax;
        double large = steep ? ay : ax;
        if (!(large > 0)) {
            return 0;
        }
        double angle = atan((steep ? ax : ay) / large);
        if (steep) {
            angle = HALF_OF_PI - angle;
        }
        if (x < 0) {
            angle = Math.PI - angle;
        }
        return y < 0 ? -angle : angle;
    }

    /** atan of a number in 0..1: atan t = atan c + atan((t − c)/(1 + tc)) brings it below tan(π/16). */
    private static double atan(double t) {
        if (t < TAN_SIXTEENTH) {
            return series(t);
        }
        if (t < TAN_THREE_SIXTEENTHS) {
            return EIGHTH_OF_PI + series((t - TAN_EIGHTH) / Math.fma(t, TAN_EIGHTH, 1));
        }
        return QUARTER_OF_PI + series((t - 1) / (t + 1));
    }

    /** Taylor's series for |t| ≤ tan(π/16); its first omitted term is below 2^-58. */
    private static double series(double t) {
        double z = t * t;
        double p = Math.fma(z, 1.0 / 21, -1.0 / 19);
        p = Math.fma(z, p, 1.0 / 17);
        p = Math.fma(z, p, -1.0 / 15);
        p = Math.fma(z, p, 1.0 / 13);
        p = Math.fma(z, p, -1.0 / 11);
        p = Math.fma(z, p, 1.0 / 9);
        p = Math.fma(z, p, -1.0 / 7);
        p = Math.fma(z, p, 1.0 / 5);
        p = Math.fma(z, p, -1.0 / 3);
        return Math.fma(z * t, p, t);
    }
}

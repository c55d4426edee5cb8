package enlightenment.frame;

import enlightenment.numeric.Scale;

/**
 * The cone of directions from a point to a ball. A mutable work object, one per thread.
 *
 * <p>With radius r, distance D and s = r/D: cosθmax = √((D − r)(D + r))/D and 1 − cosθmax = s²/(1 + cosθmax), which are accurate to a few
 * units in the last place at every distance (numerics, "Sphere light").
 */
public class BallCone {
    /** A generous bound of the roundings in {@link #misses} and {@link #isHiddenBy}. */
    private static final double TEST_ERROR = Scale.gamma(64);

    /** The apex: the point that the ball is seen from. */
    public double x;

    public double y;
    public double z;

    /** The unit vector towards the centre of the ball; (0, 0, 0) at the centre itself. */
    public double wx;

    public double wy;
    public double wz;

    /** The distance to the centre. */
    public double distance;

    /** The ball's radius. */
    public double radius;

    /** Sine and cosine of the cone's half angle. Undefined if {@link #inside}. */
    public double sine;

    public double cosine;

    /** Whether the apex lies in the ball, so that there is no cone. */
    public boolean inside;

    /** A cone to be {@link #set} before use. */
    public BallCone() {}

    /** Sets the cone from the apex (px, py, pz) around the ball at (ballX, ballY, ballZ). */
    public final void set(
            double ballX, double ballY, double ballZ, double ballRadius, double px, double py, double pz) {
        double dx = ballX - px;
        double dy = ballY - py;
        double dz = ballZ - pz;
        double d = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double inverse = d == 0 ? 0 : 1 / d;
        x = px;
        y = py;
        z = pz;
        radius = ballRadius;
        distance = d;
        wx = dx * inverse;
        wy = dy * inverse;
        wz = dz * inverse;
        inside = !(d > ballRadius);
        if (!inside) {
            sine = ballRadius * inverse;
            cosine = Math.sqrt((d - ballRadius) * (d + ballRadius)) * inverse;
        }
    }

    /**
     * Finds a box that all segments end in, those from the apex to points of the ball, or fewer.
     *
     * @param box receives the three least coordinates, then the three largest
     */
    public void findEnds(double[] box) {
        setEnds(box, 0, Math.fma(distance, wx, x));
        setEnds(box, 1, Math.fma(distance, wy, y));
        setEnds(box, 2, Math.fma(distance, wz, z));
    }

    private void setEnds(double[] box, int axis, double center) {
        box[axis] = center - radius;
        box[axis + 3] = center + radius;
    }

    /** 1 − {@link #cosine}, accurate to its last digits. */
    public final double oneMinusCosine() {
        return sine * sine / (1 + cosine);
    }

    /**
     * Whether another ball certainly intersects no segment from the apex to a point of this ball: it lies behind the apex,
     * beyond this ball, or its centre is farther than its radius from the cone's side
     * (across·cosθ − along·sinθ &gt; radius, compared squared). Conservative: false where in doubt.
     */
    public final boolean misses(double cx, double cy, double cz, double otherRadius) {
        if (inside) {
            return false;
        }
        double dx = cx - x;
        double dy = cy - y;
        double dz = cz - z;
        double end = distance + radius;
        double along = dx * wx + dy * wy + dz * wz;
        double slack = otherRadius * (1 + TEST_ERROR) + TEST_ERROR * (Math.abs(dx) + Math.abs(dy) + Math.abs(dz) + end);
        if (along < -slack || along - slack > end) {
            return true;
        }
        double cc = dx * dx + dy * dy + dz * dz;
        double reach = slack + along * sine;
        double across2 = cc - along * along - TEST_ERROR * cc;
        return reach < 0 || across2 * cosine * cosine > reach * reach * (1 + TEST_ERROR);
    }

    /**
     * Whether another ball certainly occludes this one completely: it is nearer and its own cone contains this one, that is, the
     * cosine of the angle between the axes exceeds cos(θother − θ), θother &gt; θ. Conservative: false where in doubt.
     */
    public final boolean isHiddenBy(double cx, double cy, double cz, double otherRadius) {
        if (inside) {
            return false;
        }
        double dx = cx - x;
        double dy = cy - y;
        double dz = cz - z;
        double cc = dx * dx + dy * dy + dz * dz;
        double r = otherRadius * (1 - TEST_ERROR);
        double tangent = cc - r * r;
        double nearest = distance - radius;
        // An apex that lies on the other ball may look at this one from within it; r is smaller than that by one error.
        double onBall = 2 * TEST_ERROR;
        if (!(tangent > 2 * onBall * cc) || !(tangent < nearest * nearest * (1 - TEST_ERROR))) {
            return false;
        }
        double inverse = 1 / Math.sqrt(cc);
        double otherSine = r * inverse;
        double otherCosine = Math.sqrt(tangent) * inverse;
        double along = (dx * wx + dy * wy + dz * wz) * inverse;
        return otherSine > sine && along > otherCosine * cosine + otherSine * sine + TEST_ERROR;
    }
}

package enlightenment.compiled;

/**
 * How a light is seen from a point: the cone around the ball that encloses it. A mutable work object, one per thread.
 *
 * <p>With s = radius/distance: cosθmax = √((D − r)(D + r))/D and 1 − cosθmax = s²/(1 + cosθmax), which are right to a few
 * units in the last place at every distance (numerics, "Sphere light").
 */
public final class LightCone {
    /** The direction to the middle of the light, of length 1; (0, 0, 0) at the middle itself. */
    public double wx;

    public double wy;
    public double wz;

    /** The distance to the middle. */
    public double distance;

    /** The ball's radius. */
    public double radius;

    /** Sine and cosine of the cone's half angle, and 1 − cosine. Meaningless where {@link #inside} holds. */
    public double sine;

    public double cosine;
    public double oneMinusCosine;

    /** Whether the point lies in the ball, so that there is no cone. */
    public boolean inside;

    /** Looks at a light from (x, y, z). */
    public void aim(CompiledLight light, double x, double y, double z) {
        double dx = light.ballX - x;
        double dy = light.ballY - y;
        double dz = light.ballZ - z;
        double d = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double inverse = d == 0 ? 0 : 1 / d;
        radius = light.ballRadius;
        distance = d;
        wx = dx * inverse;
        wy = dy * inverse;
        wz = dz * inverse;
        inside = !(d > radius);
        if (!inside) {
            sine = radius * inverse;
            cosine = Math.sqrt((d - radius) * (d + radius)) * inverse;
            oneMinusCosine = sine * sine / (1 + cosine);
        }
    }
}

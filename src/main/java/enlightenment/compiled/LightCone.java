package enlightenment.compiled;

import enlightenment.math.BallCone;
import enlightenment.math.Scale;

/** How a light is seen from a point: the cone around the ball that encloses it. */
public final class LightCone extends BallCone {
    /** Bounds the rounding of a distance from a plane, in units of the coordinates that are summed up. */
    private static final double PLANE_ERROR = Scale.gamma(16);

    private CompiledLight light;

    /** A cone to be aimed before use. */
    public LightCone() {}

    /** Looks at a light from (x, y, z). */
    public void aim(CompiledLight light, double px, double py, double pz) {
        this.light = light;
        set(light.ballX, light.ballY, light.ballZ, light.ballRadius, px, py, pz);
    }

    /**
     * Whether no segment from the apex to the light crosses the plane of a flat primitive: both lie on the same side of it, or
     * one of them in it. A segment that only starts or ends in a plane does not cross it.
     *
     * @param offset n·q for the plane's points q, where n = (nx, ny, nz) is its unit normal
     */
    boolean staysBeside(double nx, double ny, double nz, double offset) {
        double error = PLANE_ERROR * (Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(offset));
        double here = nx * x + ny * y + nz * z - offset;
        double there = nx * light.x + ny * light.y + nz * light.z - offset;
        double right = nx * light.right.x() + ny * light.right.y() + nz * light.right.z();
        double up = nx * light.up.x() + ny * light.up.y() + nz * light.up.z();
        double least = there - light.radius + Math.min(right, 0) + Math.min(up, 0);
        double greatest = there + light.radius + Math.max(right, 0) + Math.max(up, 0);
        double lightError = PLANE_ERROR * (light.bound + Math.abs(offset));
        return here >= -error && (here <= error || least >= -lightError)
                || here <= error && greatest <= lightError
                || least >= -lightError && greatest <= lightError;
    }
}

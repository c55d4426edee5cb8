package enlightenment.compiled;

import enlightenment.frame.BallCone;

/** How a light is seen from a point: the cone around the ball that encloses it. */
public final class LightCone extends BallCone {
    private CompiledLight light;

    /** A cone to be aimed before use. */
    public LightCone() {}

    /** Looks at a light from (x, y, z). */
    public void aim(CompiledLight light, double px, double py, double pz) {
        this.light = light;
        set(light.ballX, light.ballY, light.ballZ, light.ballRadius, px, py, pz);
    }

    /** The light that is looked at. */
    CompiledLight light() {
        return light;
    }
}

package enlightenment.world.light;

import enlightenment.frame.BallCone;

/** The cone of directions in which a light is seen from a point: that of the ball around it. */
public final class LightCone extends BallCone {
    private LightBody light;

    /** A cone to be aimed before use. */
    public LightCone() {}

    /** Sets the cone from the apex (px, py, pz) around a light. */
    public void aim(LightBody light, double px, double py, double pz) {
        this.light = light;
        set(light.ballX, light.ballY, light.ballZ, light.ballRadius, px, py, pz);
    }

    /** Tells which light the cone, which somebody else set, is around. */
    public void around(LightBody body) {
        // Mostly it is the same one, and the collector of garbage has work with each reference that is stored.
        if (light != body) {
            light = body;
        }
    }

    /** The light that the cone is around. */
    public LightBody light() {
        return light;
    }
}

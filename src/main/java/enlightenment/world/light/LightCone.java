package enlightenment.world.light;

import enlightenment.frame.BallCone;

/** The cone of directions from a point to a light's bounding ball. */
public final class LightCone extends BallCone {
    private LightBody light;

    /** A cone to be aimed before use. */
    public LightCone() {}

    /** Sets the cone from the apex (px, py, pz) around a light. */
    public void aim(LightBody light, double px, double py, double pz) {
        this.light = light;
        set(light.ballX, light.ballY, light.ballZ, light.ballRadius, px, py, pz);
    }

    /** Sets the light of a cone that was set to its bounding ball by the methods of the superclass. */
    public void around(LightBody body) {
        // Skips storing an unchanged reference, which saves the GC write barrier.
        if (light != body) {
            light = body;
        }
    }

    /** The light that the cone is around. */
    public LightBody light() {
        return light;
    }
}

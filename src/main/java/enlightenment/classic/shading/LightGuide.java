package enlightenment.classic.shading;

/**
 * A distribution of light points for each surface, light and bounce, which a method gives to a shader: where on lights that may be partly
 * occluded to look. What the shader found there is in its {@link PathReport}. Positions on a light are given in the unit disk in which
 * unguided samples are uniform.
 */
public interface LightGuide {
    /**
     * Turns to the distribution of a light as it is seen from a surface.
     *
     * @param surface the id of the primitive that is shaded
     * @param light index of the light
     * @param bounce the number of mirrors and glass surfaces before it on the path
     * @return false if samples are to be uniform in the disk, without the guide
     */
    boolean begin(int surface, int light, int bounce);

    /**
     * Chooses a position from uniform numbers (u, v) in the unit square.
     *
     * @return the uniform density over the density of this position: its importance sampling weight; 0 for a position outside
     *     the disk, where there is no light
     */
    double propose(double u, double v);

    /** The first coordinate of the chosen position. */
    double p();

    /** The second coordinate of the chosen position. */
    double q();

    /** Whether the guide samples the blocked points of the light rather than the visible ones. */
    boolean wantsBlocked();
}

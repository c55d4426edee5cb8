package enlightenment.shading;

/**
 * Importance-samples the points of lights that may be partly occluded, and learns from their visibility. Positions on a light
 * are given in the unit disk in which unguided samples are uniform.
 */
public interface LightGuide {
    /**
     * Starts sampling a light from a surface.
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

    /** Reports the visibility of the last position. */
    void tell(boolean blocked);
}

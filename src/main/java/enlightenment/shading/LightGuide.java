package enlightenment.shading;

/**
 * Chooses the points of lights that may be partly hidden, and hears what became of them. Places on a light are given in
 * the unit disk over which points are spread evenly if nobody guides.
 */
public interface LightGuide {
    /**
     * Turns to a light as seen from a surface.
     *
     * @param surface the primitive that the path is at
     * @param light index of the light
     * @param bounce how many mirrors and glass surfaces came before
     * @return false if points are to be spread evenly
     */
    boolean begin(int surface, int light, int bounce);

    /**
     * Chooses a place for (u, v) in the unit square.
     *
     * @return the density of even spreading over the density with which this place is chosen; 0 for a place outside the
     *     disk, which is nothing of the light
     */
    double propose(double u, double v);

    /** The place that was chosen: first coordinate. */
    double p();

    /** The place that was chosen: second coordinate. */
    double q();

    /** Whether the guide seeks the blocked points rather than the visible ones. */
    boolean wantsBlocked();

    /** Tells what became of the point that was chosen last. */
    void tell(boolean blocked);
}

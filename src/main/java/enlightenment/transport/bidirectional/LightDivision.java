package enlightenment.transport.bidirectional;

/**
 * Divides light that a rough vertex reflects among the first vertices of all paths of a group, which see it from different directions. One
 * per thread.
 */
public interface LightDivision {
    /**
     * Turns to light that arrives at the vertex from a direction, a unit vector.
     *
     * @return the density per solid angle with which paths that have come to the vertex from the first vertices leave it that way: the mean
     *     of the BSDF's, weighted with the densities with which the first vertices find it
     */
    double aim(double ix, double iy, double iz);

    /**
     * Divides radiance from the direction of the last {@link #aim}, over the density with which it was sampled and times its MIS weight:
     * each first vertex receives it times the BSDF, the cosine and its own share.
     */
    void divide(double r, double g, double b);
}

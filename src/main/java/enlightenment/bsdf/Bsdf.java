package enlightenment.bsdf;

/**
 * How a surface scatters light between two directions at a point (bidirectional scattering distribution function, f per steradian).
 * Immutable, shared by threads: the directions, the surface's colour and the results are in a {@link Scattering}.
 *
 * <p>Lobes are of two kinds. Those with an extent have a value and a density with respect to solid angle. Delta lobes go in single
 * directions: no direction that somebody else chose is ever one of them, so their value and density are 0, and only {@link #sample}
 * finds them, with a probability in place of the density. Which of the two an event is says its flag, never the size of a number.
 */
public sealed interface Bsdf
        permits DeltaBsdf, Lambert, RoughDiffuse, GlossyReflection, RoughDielectric, HenyeyGreenstein {
    /** Whether all lobes are delta lobes: then {@link #evaluate} and {@link #pdf} are 0 for all directions. */
    boolean isDelta();

    /** Whether light passes through the surface. */
    boolean transmits();

    /**
     * Sets the value of the directions o and i, f·|cosθ| with the angle between i and the normal, for each colour component, and their
     * {@link #pdf}; both are 0 for delta lobes. Which side i is on, its cosine says.
     */
    void evaluate(Scattering s);

    /** Sets the same of some points of a batch, which are all of surfaces of this kind; no delta lobes. */
    default void evaluate(ScatteringBatch batch, int from, int to) {
        for (int n = from; n < to; n++) {
            Scattering s = batch.get(n);
            evaluate(s);
            batch.find(n, s);
        }
    }

    /** The density per solid angle with which {@link #sample} chooses the direction i; delta lobes do not count. */
    double pdf(Scattering s);

    /**
     * Chooses a direction i for the direction o: sets it, the density or, of a delta lobe, the probability of its choice, the value
     * f·|cosθ| over that, and whether the event is one of a delta lobe and whether it is one of transmission.
     *
     * @param u with v a point of the unit square: the direction within a lobe
     * @param v see u
     * @param choice the lobe, 0..1
     * @return false if the path ends here: what was set is then of no use
     */
    boolean sample(Scattering s, double u, double v, double choice);
}

package enlightenment.bsdf;

/**
 * The bidirectional scattering distribution function f of a surface at a point, per steradian, for each colour component. Directions
 * are in the frame of the render, not in a local shading frame. Immutable, shared by threads: the directions, the surface's
 * colour and the results are in a {@link Scattering}.
 *
 * <p>Lobes are of two kinds. Non-delta lobes have a value and a density with respect to solid angle. Delta lobes scatter into single
 * directions: no independently chosen direction ever hits one, so {@link #evaluate} and {@link #pdf} are 0 for them, and only
 * {@link #sample} finds them, with a discrete probability in place of the density. {@link Scattering#delta} says which of the two was
 * sampled; it is never inferred from the size of a number.
 */
public interface Bsdf {
    /** Whether all lobes are delta lobes: then {@link #evaluate} and {@link #pdf} are 0 for all directions. */
    boolean isDelta();

    /** Whether there are delta lobes, alone or beside others: then {@link #sample} may set {@link Scattering#delta}. */
    default boolean hasDelta() {
        return isDelta();
    }

    /** Whether there are lobes of transmission. */
    boolean transmits();

    /**
     * Whether all significant lobes are so narrow that a path from the eye seldom leaves them towards a given small light: their caustics
     * are sampled like those of delta lobes (docs/notes/caustics.md).
     */
    default boolean isNarrow() {
        return false;
    }

    /** Whether a surface whose colour is black still reflects light. */
    default boolean reflectsIfBlack() {
        return false;
    }

    /** The Bsdf for code on another device; null if that does not know it. */
    default FlatBsdf flatForm() {
        return null;
    }

    /**
     * Evaluates the non-delta lobes for the directions o and i: sets f·|cosθ|, θ the angle between i and the normal, for each colour
     * component (1/sr), and {@link #pdf}. Both are 0 if all lobes are delta lobes. The sign of the cosine of i tells reflection (positive)
     * from transmission.
     */
    void evaluate(Scattering s);

    /**
     * Evaluates the non-delta lobes, as {@link #evaluate(Scattering)}, at points from..to − 1 of a batch, whose surfaces all have this kind
     * of BSDF without delta lobes.
     */
    default void evaluate(ScatteringBatch batch, int from, int to) {
        for (int n = from; n < to; n++) {
            Scattering s = batch.get(n);
            evaluate(s);
            batch.find(n, s);
        }
    }

    /**
     * The density, per solid angle, with which {@link #sample} samples the direction i given o, the probabilities of choosing between lobes
     * included; delta lobes do not count. At least 0; the integral over all directions is at most 1, since samples may be rejected.
     */
    double pdf(Scattering s);

    /**
     * Samples a direction i given o: sets i; its density per solid angle or, for a delta lobe, its discrete probability
     * ({@link Scattering#pdf}); the sample weight f·|cosθ|/pdf ({@link Scattering#valueR} and so on, dimensionless); and the flags
     * {@link Scattering#delta} and {@link Scattering#transmitted}.
     *
     * @param u with v a uniform point of the unit square, which selects the direction within a lobe
     * @param v see u
     * @param choice uniform in [0, 1), selects the lobe
     * @return false if no direction was sampled and the path ends here; what was set must then not be used
     */
    boolean sample(Scattering s, double u, double v, double choice);
}

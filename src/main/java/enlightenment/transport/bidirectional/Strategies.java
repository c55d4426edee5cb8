package enlightenment.transport.bidirectional;

/**
 * Observes, and may change, the MIS weight of each strategy: a path with t vertices from the eye, the eye included, and s from a light. For
 * tests; a render has none.
 */
public interface Strategies {
    /**
     * Called for each unoccluded path.
     *
     * @param weight its MIS weight
     * @return the weight to use instead
     */
    double weight(int s, int t, double weight);
}

package enlightenment.transport.bidirectional;

/**
 * Looks at what each strategy finds, and may change it: a path with t vertices from the eye, the eye itself among them, and s from a light.
 * For tests; a render has none.
 */
public interface Strategies {
    /**
     * A path was found, and is not blocked.
     *
     * @param weight its weight among all strategies
     * @return what to use in place of the weight
     */
    double weight(int s, int t, double weight);
}

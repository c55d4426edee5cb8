package enlightenment.transport.state;

/** MIS weights by the power heuristic with exponent 2 (E. Veach and L. Guibas, "Optimally combining sampling techniques", 1995). */
public final class PowerHeuristic {
    private PowerHeuristic() {}

    /**
     * The weight of a technique beside one other. The ratio is formed first: no square overflows.
     *
     * @param other the density of the other technique for the same path
     * @param own the density of the technique itself
     */
    public static double weight(double other, double own) {
        double ratio = other / own;
        return 1 / (1 + ratio * ratio);
    }

    /** The weight of a technique beside two others; see {@link #weight(double, double)}. */
    public static double weight(double other, double another, double own) {
        double ratio = another / own;
        double first = other / own;
        return 1 / (1 + first * first + ratio * ratio);
    }

    /** The density of one technique that weighs as much as two others together: the root of the sum of their squares. */
    public static double both(double one, double other) {
        return other == 0 ? one : Math.sqrt(Math.fma(one, one, other * other));
    }
}

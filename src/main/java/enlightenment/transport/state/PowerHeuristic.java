package enlightenment.transport.state;

/**
 * The weights of two techniques that find the same light, so that both together count it once: the power heuristic with exponent 2
 * (E. Veach and L. Guibas, "Optimally combining sampling techniques", 1995).
 */
public final class PowerHeuristic {
    private PowerHeuristic() {}

    /**
     * The weight of the technique with the density own. The ratio is formed first: no square overflows.
     *
     * @param other the density with which the other technique finds the same
     */
    public static double weight(double other, double own) {
        double ratio = other / own;
        return 1 / (1 + ratio * ratio);
    }

    /** The same if two others find it. */
    public static double weight(double other, double another, double own) {
        double ratio = another / own;
        double first = other / own;
        return 1 / (1 + first * first + ratio * ratio);
    }

    /** The density that weighs as much as two others do. */
    public static double both(double one, double other) {
        return other == 0 ? one : Math.sqrt(Math.fma(one, one, other * other));
    }
}

package enlightenment.method.metropolis;

/**
 * The distribution of a picture's samples, per pixel in the mean.
 *
 * @param direct camera rays for direct light alone; 0 where chains make all light
 * @param independent independent paths, which estimate the brightness of a block and start its chains
 * @param mutations steps of chains
 */
record Spending(double direct, double independent, double mutations) {
    /** The share of direct samples, measured on light that is hard to find: docs/notes/metropolis.md. */
    private static final double DIRECT = 0.25;

    private static final double INDEPENDENT = 0.5;

    /** One direct sample for each quarter of a pixel. */
    private static final int LEAST_DIRECT = 4;

    static Spending of(double samples, boolean isPhysical) {
        double direct = isPhysical ? Math.max(DIRECT * samples, LEAST_DIRECT) : 0;
        double paths = Math.max(samples - direct, 1);
        return new Spending(direct, INDEPENDENT * paths, (1 - INDEPENDENT) * paths);
    }
}

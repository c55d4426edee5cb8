package enlightenment.measure;

/** Runs whose time and error are known. */
final class SyntheticRuns {
    private SyntheticRuns() {}

    static TradeRun run(String method, double samples, long seed, double meanSquaredDifference, double wall) {
        double e = Math.sqrt(meanSquaredDifference);
        return new TradeRun(
                TradeRun.LADDER,
                method,
                4,
                10,
                2,
                samples,
                seed,
                wall,
                2 * wall,
                samples,
                meanSquaredDifference,
                e,
                e,
                0.9 * e,
                1.1 * e);
    }
}

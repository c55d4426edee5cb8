package enlightenment.measure.trade;

/**
 * One timed render and its error.
 *
 * @param kind why it was made: {@link #BUDGET_SERIES}, {@link #CHECK}, {@link #EQUAL_TIME}, or {@link #SWEEP} and the sweep's name
 * @param method the method
 * @param antialias n for the n × n grid of positions per pixel; used where {@code samples} is 0
 * @param shadowSamples light samples per hit and light; 0 with physical shading
 * @param threads threads that shared the work
 * @param samples the budget of camera rays per pixel; 0 where {@code antialias} decided
 * @param seed the seed of its random numbers
 * @param wallSeconds time by the clock from the scene in memory to the finished image, without reading or writing files
 * @param cpuSeconds processor time of all threads; 0 where the system does not report it
 * @param samplesPerPixel camera rays per pixel that were traced, surveys included
 * @param meanSquaredDifference mean squared difference from the reference, which includes the reference's own variance;
 *     square of display units
 * @param flip mean FLIP difference from the reference, 0..1
 * @param estimatedError the root mean square error that the render estimated of itself, in display units
 * @param estimatedLow lower end of its 95 % interval
 * @param estimatedHigh upper end of it
 */
public record TradeRun(
        String kind,
        String method,
        int antialias,
        int shadowSamples,
        int threads,
        double samples,
        long seed,
        double wallSeconds,
        double cpuSeconds,
        double samplesPerPixel,
        double meanSquaredDifference,
        double flip,
        double estimatedError,
        double estimatedLow,
        double estimatedHigh) {
    /** One of the budgets 1, 2, 4, ... samples per pixel. */
    public static final String BUDGET_SERIES = "ladder";

    /** The advice, rendered with the scene's own seed exactly as given. */
    public static final String CHECK = "check";

    /** Rendered to take as long as the pictures of the other methods. */
    public static final String EQUAL_TIME = "equal time";

    /** The beginning of the kind of a sweep's runs; the sweep's name follows. */
    public static final String SWEEP = "sweep ";

    /** Where the reference makes up more than this share of the squared difference, its error is the larger of the two. */
    private static final double MOST_OF_REFERENCE = 0.5;

    /**
     * The root mean square error in display units: √(difference² − reference²), 0 where that would be negative. The errors of
     * render and reference are independent, so their variances add up in the difference.
     *
     * @param referenceVariance the reference's own mean squared error
     */
    public double error(double referenceVariance) {
        return Math.sqrt(Math.max(meanSquaredDifference - referenceVariance, 0));
    }

    /** Whether the error can be distinguished from the reference's: it is at least as large. */
    public boolean isJudged(double referenceVariance) {
        return meanSquaredDifference > 0 && referenceVariance <= MOST_OF_REFERENCE * meanSquaredDifference;
    }

    /** This run with the times of a repetition, whose image is equal to the last bit. */
    public TradeRun withTimes(double wall, double cpu) {
        return new TradeRun(
                kind,
                method,
                antialias,
                shadowSamples,
                threads,
                samples,
                seed,
                wall,
                cpu,
                samplesPerPixel,
                meanSquaredDifference,
                flip,
                estimatedError,
                estimatedLow,
                estimatedHigh);
    }
}

package enlightenment.measure.trade;

/**
 * A timed render with its error.
 *
 * @param kind purpose of the run: {@link #BUDGET_SERIES}, {@link #CHECK}, {@link #EQUAL_TIME}, or {@link #SWEEP} and the sweep's name
 * @param method the method
 * @param antialias n for the n × n grid of positions per pixel; used where {@code samples} is 0
 * @param shadowSamples light samples per hit and light; 0 with physical shading
 * @param threads threads that shared the work
 * @param samples the budget of camera rays per pixel; 0 where {@code antialias} decided
 * @param seed the seed of the random numbers
 * @param wallSeconds time by the clock from the scene in memory to the finished image, without reading or writing files
 * @param cpuSeconds processor time of all threads; 0 where the system does not report it
 * @param samplesPerPixel camera rays per pixel that were traced, surveys included
 * @param meanSquaredDifference mean squared difference from the reference, which includes the reference's own variance;
 *     square of display units
 * @param flip mean FLIP difference from the reference, 0..1
 * @param estimatedError the root mean square error that the render estimated of itself, in display units
 * @param estimatedLow lower end of the 95 % interval of {@code estimatedError}
 * @param estimatedHigh upper end of that interval
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
    /** Runs with budgets of 1, 2, 4, ... samples per pixel. */
    public static final String BUDGET_SERIES = "ladder";

    /** Runs of the advice, exactly as given, with the scene's own seed. */
    public static final String CHECK = "check";

    /** Runs that take as long as those of the other methods. */
    public static final String EQUAL_TIME = "equal time";

    /** Prefix of the kind of a sweep's runs; the sweep's name follows. */
    public static final String SWEEP = "sweep ";

    /** Share of the squared difference above which the reference has the larger error of the two. */
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

    /** Whether the error can be distinguished from the reference's, being at least as large. */
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

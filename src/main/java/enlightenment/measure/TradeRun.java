package enlightenment.measure;

/**
 * One timed render and what it was worth.
 *
 * @param kind what it was made for: one of {@link #LADDER}, {@link #CHECK}, {@link #EQUAL_TIME}, or {@code "sweep NAME"}
 * @param method the method
 * @param antialias positions per pixel along one side, where no number of samples is given
 * @param shadowSamples light points per hit and light
 * @param threads threads that shared the work
 * @param samples the budget of camera rays per pixel; 0 where {@code antialias} decided
 * @param seed what the random numbers came from
 * @param wallSeconds time by the clock from scene description to finished picture, without reading and writing files
 * @param cpuSeconds processor time of all threads; 0 where the machine cannot tell
 * @param samplesPerPixel camera rays per pixel that were taken, those of surveys included
 * @param meanSquaredDifference from the reference, whose own error it includes; display units squared
 * @param flip mean FLIP difference from the reference, 0..1
 * @param estimatedError the root mean square error that the render itself expected
 * @param estimatedLow lower end of its interval for that
 * @param estimatedHigh upper end
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
    /** A rung of the ladder of budgets. */
    public static final String LADDER = "ladder";

    /** The verdict, tried to the letter. */
    public static final String CHECK = "check";

    /** Made to take as long as the pictures of the other methods. */
    public static final String EQUAL_TIME = "equal time";

    /** What the kind of a sweep's runs begins with. */
    public static final String SWEEP = "sweep ";

    /** With more than this share of the difference made up by the reference, the render's error is the smaller of the two. */
    private static final double MOST_OF_REFERENCE = 0.5;

    /**
     * The root mean square error. The reference's error is independent of the render's, so their squares add up in the
     * difference, and one can be taken off again.
     *
     * @param referenceVariance mean squared error of the reference itself
     */
    public double error(double referenceVariance) {
        return Math.sqrt(Math.max(meanSquaredDifference - referenceVariance, 0));
    }

    /** Whether the error is known: it is at least as large as the reference's own. */
    public boolean isJudged(double referenceVariance) {
        return meanSquaredDifference > 0 && referenceVariance <= MOST_OF_REFERENCE * meanSquaredDifference;
    }

    /** The same run with other times: a repetition gives the same picture to the last bit. */
    TradeRun withTimes(double wall, double cpu) {
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

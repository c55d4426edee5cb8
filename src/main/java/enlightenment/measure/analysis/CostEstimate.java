package enlightenment.measure.analysis;

import enlightenment.measure.trade.Spread;
import java.util.List;
import java.util.Optional;

/**
 * The cost of an error with one configuration, and the evidence for it.
 *
 * @param configuration method and number of light samples
 * @param target the root mean square error to reach, in display units 0..1
 * @param samples the budget of camera rays per pixel that reaches it
 * @param error the error that this budget gives
 * @param wall seconds by the clock
 * @param cpu seconds of all processors, where they were measured
 * @param flip the mean FLIP difference that this budget gives, where it was measured
 * @param source kind of evidence
 * @param from the measured errors of the evidence: of this budget, of its two neighbours, or the smallest one
 */
public record CostEstimate(
        Configuration configuration,
        double target,
        double samples,
        double error,
        Spread wall,
        Optional<Spread> cpu,
        Optional<Double> flip,
        Source source,
        List<Double> from) {
    /** Share of the target below which an error clearly costs more than the target, as an upper bound only. */
    public static final double CLOSE = 0.85;

    public CostEstimate {
        from = List.copyOf(from);
    }

    /** Kind of evidence for a cost. */
    public enum Source {
        /** Exactly this budget was rendered with the scene's own seed: following the advice gives that image. */
        TRIED,
        /** This budget was rendered with other random numbers, and gave the error or a smaller one. */
        MEASURED,
        /**
         * This budget was rendered, and its error is below the reference's own; how far below is unknown. The error stated is
         * the reference's.
         */
        BELOW,
        /** The cost was interpolated between a rendered budget of larger and one of smaller error. */
        BETWEEN,
        /** The cost was extrapolated beyond the rendered budgets. */
        BEYOND
    }

    /** Whether the cost lies within the rendered budgets. */
    public boolean isMeasured() {
        return source != Source.BEYOND;
    }

    /** Whether the budget's error is clearly below the target, so that a smaller budget might do. */
    public boolean undercutsTarget() {
        return source == Source.BELOW || error < CLOSE * target;
    }

    /** This cost with the error that the budget gives as the target. */
    CostEstimate atItsOwnError() {
        return new CostEstimate(configuration, error, samples, error, wall, cpu, flip, source, from);
    }

    /** The method. */
    public String method() {
        return configuration.method();
    }

    /** The evidence, in words for brackets. */
    public String evidence() {
        return switch (source) {
            case TRIED -> undercutsTarget() ? "tried, gives " + Digits.of(error, 2) : "tried";
            case MEASURED -> undercutsTarget() ? "measured, gives " + Digits.of(error, 2) + " or less" : "measured";
            case BELOW -> "measured, gives less than the reference's own error of " + Digits.of(error, 2);
            case BETWEEN ->
                "interpolated between measured errors of " + Digits.of(from.get(0), 2) + " and "
                        + Digits.of(from.get(1), 2);
            case BEYOND -> "extrapolated from " + Digits.of(from.get(0), 2) + ", the smallest error measured";
        };
    }
}

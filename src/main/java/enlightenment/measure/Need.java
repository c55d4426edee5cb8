package enlightenment.measure;

import java.util.List;
import java.util.Optional;

/**
 * What a contender needs for an error, and how that is known.
 *
 * @param contender method and number of light points
 * @param target the root mean square error that is wanted, in display units 0..1
 * @param samples the budget of camera rays per pixel that leads there
 * @param error the error that it gives
 * @param wall seconds by the clock
 * @param cpu seconds of all processors, where they were measured
 * @param flip the mean FLIP difference that it gives, where it was measured
 * @param source how that is known
 * @param from the measured errors that this comes from: its own, those on either side, or the smallest there is
 */
public record Need(
        Contender contender,
        double target,
        double samples,
        double error,
        Spread wall,
        Optional<Spread> cpu,
        Optional<Double> flip,
        Source source,
        List<Double> from) {
    /** Below this share of the wanted error, an error is another one: the time for it says little of the time for the other. */
    private static final double STILL = 0.85;

    public Need {
        from = List.copyOf(from);
    }

    /** How a need is known. */
    public enum Source {
        /** This very budget was rendered with the scene's own seed, as whoever follows the advice will do. */
        TRIED,
        /** This budget was rendered with other random numbers, and gave the error or a smaller one. */
        MEASURED,
        /**
         * This budget was rendered, and its error is below the reference's own: how far below cannot be told. The error stated is
         * the reference's.
         */
        BELOW,
        /** It lies between two budgets that were rendered and gave a larger error and a smaller one. */
        BETWEEN,
        /** It lies beyond what was rendered. */
        BEYOND
    }

    /** Whether it lies within what was measured. */
    public boolean isMeasured() {
        return source != Source.BEYOND;
    }

    /** Whether the error that it gives is clearly smaller than the one that is wanted, so that less time might do. */
    public boolean isMoreThanAsked() {
        return source == Source.BELOW || error < STILL * target;
    }

    /** The same as an answer to the question what the error that it gives needs. */
    Need forWhatItGives() {
        return new Need(contender, error, samples, error, wall, cpu, flip, source, from);
    }

    /** The method. */
    public String method() {
        return contender.method();
    }

    /** Where it comes from, in words that can stand in brackets. */
    public String evidence() {
        return switch (source) {
            case TRIED -> isMoreThanAsked() ? "tried, gives " + Digits.of(error, 2) : "tried";
            case MEASURED -> isMoreThanAsked() ? "measured, gives " + Digits.of(error, 2) + " or less" : "measured";
            case BELOW -> "measured, gives less than the reference's own error of " + Digits.of(error, 2);
            case BETWEEN ->
                "interpolated between measured errors of " + Digits.of(from.get(0), 2) + " and "
                        + Digits.of(from.get(1), 2);
            case BEYOND -> "extrapolated from " + Digits.of(from.get(0), 2) + ", the smallest error measured";
        };
    }
}

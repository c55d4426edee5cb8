package enlightenment.measure;

import java.util.Optional;

/**
 * What a method needs for an error.
 *
 * @param method the method
 * @param target the root mean square error that is wanted, in display units 0..1
 * @param samples the budget of camera rays per pixel that leads there
 * @param error the error that it gives
 * @param wall seconds by the clock
 * @param cpu seconds of all processors, where they were measured
 * @param source how that is known
 */
public record Need(
        String method, double target, double samples, double error, Spread wall, Optional<Spread> cpu, Source source) {

    /** How a need is known. */
    public enum Source {
        /** This very budget was rendered with the scene's own seed, as whoever follows the advice will do. */
        TRIED,
        /** It lies between two budgets that were rendered. */
        BETWEEN,
        /** It lies beyond what was rendered. */
        BEYOND
    }
}

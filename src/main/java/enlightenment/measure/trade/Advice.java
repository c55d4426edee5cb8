package enlightenment.measure.trade;

import enlightenment.scene.RenderSettings;
import java.util.Optional;

/**
 * What to render with for an error, in the least time that was found.
 *
 * @param error the root mean square error to reach, in display units 0..1
 * @param basis what the advice rests on
 * @param settings settings that reach the error; empty where {@code basis} is {@link Basis#NOTHING}
 * @param seconds the render's time by the clock on the machine of the measurement; empty as {@code settings}
 * @param sentence the advice in one English sentence, each figure followed by the measurement it comes from
 */
public record Advice(
        double error, Basis basis, Optional<RenderSettings> settings, Optional<Spread> seconds, String sentence) {
    /** What advice rests on. */
    public enum Basis {
        /** The advice was measured, and so was everything it is compared with in numbers. */
        MEASURED,
        /** It was extrapolated from larger errors, and the sentence says so. */
        EXTRAPOLATED,
        /** Nothing is known at this error, and the sentence says why. */
        NOTHING
    }
}

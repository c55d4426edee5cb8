package enlightenment.measure.trade;

import enlightenment.scene.RenderSettings;
import java.util.Optional;

/**
 * The advice for an error: settings that reach it in the least time found.
 *
 * @param error the root mean square error to reach, in display units 0..1
 * @param basis the evidence of the advice
 * @param settings settings that reach the error; empty if {@code basis} is {@link Basis#NOTHING}
 * @param seconds the render's time by the clock on the machine of the measurement; empty if {@code settings} is
 * @param sentence the advice in one English sentence, each figure followed by the measurement it comes from
 */
public record Advice(
        double error, Basis basis, Optional<RenderSettings> settings, Optional<Spread> seconds, String sentence) {
    /** The evidence of an advice. */
    public enum Basis {
        /** The advice was measured, as was everything it is compared with in numbers. */
        MEASURED,
        /** The advice was extrapolated from larger errors, and the sentence says so. */
        EXTRAPOLATED,
        /** Nothing is known at this error, and the sentence says why. */
        NOTHING
    }
}

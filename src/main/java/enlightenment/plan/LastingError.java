package enlightenment.plan;

import enlightenment.compiled.ChanceError;
import enlightenment.compiled.CompiledScene;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.function.BooleanSupplier;

/**
 * The error of light that a method finds by chance only, or never, which is left after as many samples as are tried for an error.
 *
 * @param square its mean square, in displayed units; at least 0
 * @param why what light that is and what finds it, in plain words
 */
record LastingError(double square, String why) {
    /** A method that finds all light. */
    static final LastingError NONE = new LastingError(0, "");

    /** That of a scene by the method of the settings, in the part of the picture that is rendered; parameters as of {@link Integrators#chance}. */
    static LastingError of(RenderSettings settings, CompiledScene scene, double samples, BooleanSupplier cancelled) {
        Method method = settings.method();
        ChanceError error = Integrators.chance(method, scene, samples, settings.region(), cancelled);
        if (!(error.shortfall() > 0)) {
            return NONE;
        }
        boolean isInMedia = method != BuiltInMethod.BIDIRECTIONAL
                && Integrators.chance(BuiltInMethod.BIDIRECTIONAL, scene, samples, settings.region(), cancelled)
                                .shortfall()
                        < error.shortfall() / 2;
        return new LastingError(
                error.shortfall(),
                isInMedia
                        ? "of points and small lamps in media whose border refracts; try --method "
                                + BuiltInMethod.BIDIRECTIONAL.word()
                        : "of mirrors and glass seen in mirrors and through glass, or of points and the sun in media"
                                + " whose border refracts; larger lamps are found");
    }
}

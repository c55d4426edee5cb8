package enlightenment.plan;

import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.function.BooleanSupplier;

/** The plan for a number of samples per pixel: with which method they are taken, and at which level. */
final class SamplePlans {
    /** From this many light paths per camera sample on, they are a good part of the work. */
    private static final double MANY_PATHS = 0.5;

    private final Method method;
    private final MethodTraits traits;
    private final double antialias;
    private final double tracedPixels;
    private final Levels levels;
    private final Levels levelsBelow;
    private final double lightPathsPerSample;
    private final double picturePixels;

    SamplePlans(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        method = settings.method();
        traits = Integrators.traits(method, settings, scene.physical != null);
        RenderSettings.Crop region = settings.region();
        // Paths that may end anywhere are followed for a part of the picture as for the whole.
        tracedPixels = traits.areBatches()
                ? (double) settings.width() * settings.height()
                : (double) region.width() * region.height();
        antialias = (double) settings.antialias() * settings.antialias();
        levels = Integrators.levels(method, scene, settings, cancelled);
        levelsBelow = Integrators.levels(traits.below(), scene, settings, cancelled);
        lightPathsPerSample = Integrators.lightPathsPerSample(method, scene, settings);
        picturePixels = (double) settings.width() * settings.height();
    }

    /** The plan without a budget: antialias² samples per pixel. */
    RenderPlan ofAntialias() {
        return Integrators.hasLevelOfAntialias(method)
                ? plan(method, 0, antialias, "antialias")
                : of(antialias, "antialias");
    }

    /**
     * The plan for this many samples per pixel.
     *
     * @param by which part of the budget was decisive
     * @throws java.util.concurrent.CancellationException if it is cancelled before that is known
     */
    RenderPlan of(double samples, String by) {
        return isPossible(samples)
                ? plan(method, levels.of(samples), samples, by)
                : plan(traits.below(), levelsBelow.of(samples), samples, by);
    }

    /** Light paths are for a part of the picture as many as for the whole, since they may end anywhere. */
    private RenderPlan plan(Method chosen, double level, double samples, String by) {
        return new RenderPlan(
                chosen, level, samples, by, (long) Math.ceil(lightPathsPerSample * samples * picturePixels));
    }

    /** Whether much of the work is paths that may end anywhere: tiles then sample little of the picture's error. */
    boolean areMostlyPaths() {
        return traits.areBatches() || lightPathsPerSample >= MANY_PATHS;
    }

    /** Whether paths that may end anywhere are splatted over the tiles. */
    boolean haveLightPaths() {
        return lightPathsPerSample > 0;
    }

    /** The number of pixels whose samples a render takes. */
    double tracedPixels() {
        return tracedPixels;
    }

    /** The traits of the settings' method. */
    MethodTraits traits() {
        return traits;
    }

    /** Whether the method of the settings itself can be given so few samples. */
    boolean isPossible(double samples) {
        return samples >= traits.fewest();
    }

    /** Whether with this many samples the picture is surveyed first: only where another method is used for fewer. */
    boolean isSurveyed(double samples) {
        return traits.below() != method && isPossible(samples);
    }

    /** Works out now what all plans with a survey have in common. */
    void prepareSurveyed() {
        levels.prepare();
    }

    /** The largest cost of finding the level of another number of samples, in rays per rendered pixel. */
    double planningRays() {
        return levels.planningRays();
    }
}

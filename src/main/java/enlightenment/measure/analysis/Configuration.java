package enlightenment.measure.analysis;

import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;

/**
 * The settings, budget aside, that distinguish renders in a comparison.
 *
 * @param method the method
 * @param lightSamples light samples per hit and light; 0 with physical shading, which has no such setting
 * @param grid whether budgets are given as {@code --antialias} instead of {@code --samples}: the positions in the pixel differ
 */
public record Configuration(String method, int lightSamples, boolean grid) {
    /** The ratio of neighbouring variants. Measured: within a factor of two of the best number the cost hardly differs. */
    private static final int STEP = 4;

    /** A method with the scene's own number of light samples. */
    public static Configuration ofScene(TradeSettings settings, String method) {
        int lightSamples = settings.shading() == Shading.Model.PHYSICAL
                ? 0
                : BuiltInMethod.RayTraceSettings.of(settings.base()).shadowSamples();
        return new Configuration(method, lightSamples, false);
    }

    /** The configuration of a run. */
    public static Configuration of(TradeRun run) {
        return new Configuration(run.method(), run.shadowSamples(), run.samples() == 0);
    }

    /**
     * Variants with other numbers of light samples: powers of four up to half of the scene's own, and four times that.
     */
    public static List<Configuration> variants(Configuration own) {
        List<Configuration> variants = new ArrayList<>();
        if (!own.takesLightSamples()) {
            return variants;
        }
        for (int n = 1; 2 * n <= own.lightSamples; n *= STEP) {
            variants.add(new Configuration(own.method, n, false));
        }
        if (own.lightSamples <= BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.max() / STEP) {
            variants.add(new Configuration(own.method, STEP * own.lightSamples, false));
        }
        return variants;
    }

    /** Whether the method takes a fixed number of light samples per hit instead of choosing it. */
    private boolean takesLightSamples() {
        return lightSamples > 0
                && Method.of(method)
                        .filter(m -> m.settings().contains(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES))
                        .isPresent();
    }

    /** Whether a run has this configuration. */
    public boolean made(TradeRun run) {
        return equals(of(run));
    }

    /** The settings of a render with this budget of camera rays per pixel. */
    public RenderSettings settings(RenderSettings base, double samples, long seed) {
        RenderSettings own = base.withMethod(Method.named(method)).withSeed(seed);
        if (lightSamples > 0) {
            own = own.with(BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES, lightSamples);
        }
        return grid
                ? own.withAntialias(side(samples)).withBudget(RenderSettings.Budget.NONE)
                : own.withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    private static int side(double samples) {
        return (int) Math.round(Math.sqrt(samples));
    }

    /** The name in sentences: the method, and its number of light samples. */
    public String name() {
        String name = grid ? method + " --antialias" : method;
        return takesLightSamples()
                ? name + " with " + lightSamples + (lightSamples == 1 ? " light sample" : " light samples")
                : name;
    }

    /**
     * The options of {@code render} for a budget of camera rays per pixel.
     *
     * @param sceneLightSamples the scene's own number of light samples, which needs no option
     */
    String options(double samples, int sceneLightSamples) {
        String budget = grid ? " --antialias " + side(samples) : " --samples " + Digits.samples(samples);
        return "--method " + method
                + (lightSamples == sceneLightSamples || lightSamples == 0
                        ? ""
                        : " " + BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES.option() + " " + lightSamples)
                + budget;
    }
}

package enlightenment.measure;

import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderDefaults;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;

/**
 * A way to spend a budget, with which others are compared.
 *
 * @param method the method
 * @param lightPoints light points per hit and light
 * @param grid whether its budgets are given as {@code --antialias} and not as {@code --samples}: the positions in the pixel differ
 */
public record Contender(String method, int lightPoints, boolean grid) {
    /** From one number of light points to the next; measured: the cost of the best differs little within a factor of two. */
    private static final int STEP = 4;

    /** What made a run. */
    public static Contender of(TradeRun run) {
        return new Contender(run.method(), run.shadowSamples(), run.samples() == 0);
    }

    /**
     * The other numbers of light points that a method is compared with: the powers of four up to half of the scene's own, and
     * four times that.
     */
    static List<Contender> variants(Contender own) {
        List<Contender> variants = new ArrayList<>();
        if (!own.takesLightPoints()) {
            return variants;
        }
        for (int n = 1; 2 * n <= own.lightPoints; n *= STEP) {
            variants.add(new Contender(own.method, n, false));
        }
        if (own.lightPoints <= RenderDefaults.MAX_SHADOW_SAMPLES / STEP) {
            variants.add(new Contender(own.method, STEP * own.lightPoints, false));
        }
        return variants;
    }

    /** Whether the method takes this many light points for each hit, instead of deciding by itself. */
    private boolean takesLightPoints() {
        return Method.of(method)
                .filter(m -> m.has(Method.Setting.SHADOW_SAMPLES))
                .isPresent();
    }

    /** Whether a run is one of this contender's. */
    public boolean made(TradeRun run) {
        return equals(of(run));
    }

    /** The settings of a render with this budget. */
    RenderSettings settings(RenderSettings base, double samples, long seed) {
        return base.withMethod(Method.named(method))
                .withShadowSamples(lightPoints)
                .withBudget(Budget.NONE.withSamples(samples))
                .withSeed(seed);
    }

    /** What it is called: the method, and how many light points it takes. */
    public String name() {
        String name = grid ? method + " --antialias" : method;
        return takesLightPoints()
                ? name + " with " + lightPoints + (lightPoints == 1 ? " light point" : " light points")
                : name;
    }

    /** The options of {@code render} for a budget of so many camera rays per pixel; {@code own} is the scene's light points. */
    String options(double samples, int own) {
        String budget =
                grid ? " --antialias " + Math.round(Math.sqrt(samples)) : " --samples " + Digits.samples(samples);
        return "--method " + method + (lightPoints == own ? "" : " --shadow-samples " + lightPoints) + budget;
    }
}

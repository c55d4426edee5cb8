package enlightenment.measure.trade;

import enlightenment.check.Check;
import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;

/**
 * Settings of a measurement. {@link #of} has the usual values; the {@code with} methods change one.
 *
 * @param shading the shading model of the scene
 * @param base the settings that all renders share; its method is that of the sweeps, its budget is not used
 * @param methods the words of the methods to compare, each once, at least one
 * @param budgetSeconds approximate seconds of the measurement by the clock, greater than 0. The least renders for a result are always
 *     made
 * @param seeds number of renders of each budget, each with other random numbers; 1..{@link #MAX_SEEDS}
 * @param sweeps sweeps of settings
 * @param reference the reference image, as large as the renders; empty to make it from long renders
 * @param sceneKey identity of the scene, kept in the folder, so that no measurement of another scene is resumed in it
 */
public record TradeSettings(
        Shading.Model shading,
        RenderSettings base,
        List<String> methods,
        double budgetSeconds,
        int seeds,
        List<Sweep> sweeps,
        Optional<Image> reference,
        String sceneKey) {
    /** The largest value of {@link #seeds}. */
    public static final int MAX_SEEDS = 1000;

    /** The usual share of {@link #budgetSeconds} for each method, and its smallest usual value. */
    private static final double SECONDS_PER_METHOD = 45;

    private static final double FEWEST_SECONDS = 90;

    /** The usual value of {@link #seeds}. */
    public static final int SEEDS = 3;

    /**
     * Checks the values.
     *
     * @throws enlightenment.math.InvalidValueException key "methods", "budget", "seeds" or "reference", or that of a setting whose
     *     sweep leaves its range
     */
    public TradeSettings {
        methods = List.copyOf(methods);
        sweeps = List.copyOf(sweeps);
        Check.that(!methods.isEmpty(), "methods", "must name at least one method");
        if (!methods.stream().allMatch(word -> Method.of(word).isPresent())) {
            throw new InvalidValueException("methods", "must be some of " + Method.words() + ", not " + methods);
        }
        Check.that(new HashSet<>(methods).size() == methods.size(), "methods", "must name each method once");
        Check.that(
                budgetSeconds > 0 && budgetSeconds < Double.POSITIVE_INFINITY,
                "budget",
                "must be greater than 0, not " + budgetSeconds);
        Check.that(seeds >= 1 && seeds <= MAX_SEEDS, "seeds", "must lie in 1.." + MAX_SEEDS + ", not " + seeds);
        for (Sweep sweep : sweeps) {
            sweep.values().forEach(v -> sweep.at(base, v));
        }
        if (reference.isPresent()) {
            Image r = reference.get();
            RenderSettings.Crop region = base.region();
            Check.that(
                    r.width() == region.width() && r.height() == region.height(),
                    "reference",
                    "must have " + region.width() + "x" + region.height() + " pixels, as the renders, not " + r.width()
                            + "x" + r.height());
        }
    }

    /** The usual {@link #budgetSeconds} for a number of methods: 90 for one or two, 45 more for each further one. */
    public static double budgetSeconds(int methods) {
        return Math.max(SECONDS_PER_METHOD * methods, FEWEST_SECONDS);
    }

    /**
     * The usual settings: all built-in methods for a shading, {@link #budgetSeconds(int)}, {@link #SEEDS}, no sweeps, and no reference image.
     */
    public static TradeSettings of(RenderSettings base, Shading.Model shading, String sceneKey) {
        List<String> methods = Method.words(BuiltInMethod.rendering(shading));
        return new TradeSettings(
                shading, base, methods, budgetSeconds(methods.size()), SEEDS, List.of(), Optional.empty(), sceneKey);
    }

    /** These settings with another list of {@link #methods}. */
    public TradeSettings withMethods(List<String> methods) {
        return new TradeSettings(shading, base, methods, budgetSeconds, seeds, sweeps, reference, sceneKey);
    }

    /** These settings with another {@link #budgetSeconds}. */
    public TradeSettings withBudgetSeconds(double budgetSeconds) {
        return new TradeSettings(shading, base, methods, budgetSeconds, seeds, sweeps, reference, sceneKey);
    }

    /** These settings with another number of {@link #seeds}. */
    public TradeSettings withSeeds(int seeds) {
        return new TradeSettings(shading, base, methods, budgetSeconds, seeds, sweeps, reference, sceneKey);
    }

    /** These settings with other {@link #sweeps}. */
    public TradeSettings withSweeps(List<Sweep> sweeps) {
        return new TradeSettings(shading, base, methods, budgetSeconds, seeds, sweeps, reference, sceneKey);
    }

    /** These settings with a given {@link #reference}. */
    public TradeSettings withReference(Image reference) {
        return new TradeSettings(
                shading, base, methods, budgetSeconds, seeds, sweeps, Optional.of(reference), sceneKey);
    }
}

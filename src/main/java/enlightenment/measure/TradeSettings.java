package enlightenment.measure;

import enlightenment.check.Check;
import enlightenment.image.Image;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;

/**
 * What to measure.
 *
 * @param base the settings that all renders share; its method serves the sweeps, its budget is not used
 * @param methods the methods to compare, each once
 * @param budgetSeconds about how long all of it may take; greater than 0. The least that gives a result is done in any case
 * @param seeds how many times each rung is rendered, with random numbers of its own; 1..1000
 * @param sweeps switches to turn notch by notch
 * @param reference what to take for the truth; made from renders of the methods where there is none
 * @param sceneKey tells this scene from others; goes into the folder, so that nothing else goes on in it
 */
public record TradeSettings(
        RenderSettings base,
        List<String> methods,
        double budgetSeconds,
        int seeds,
        List<Sweep> sweeps,
        Optional<Image> reference,
        String sceneKey) {
    /** More renders of one rung than this tell nothing more. */
    public static final int MAX_SEEDS = 1000;

    public TradeSettings {
        methods = List.copyOf(methods);
        sweeps = List.copyOf(sweeps);
        Check.that(!methods.isEmpty(), "methods", "must name at least one method");
        Check.that(
                Method.words().containsAll(methods),
                "methods",
                "must be some of " + Method.words() + ", not " + methods);
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

    /** A method with the scene's own number of light points. */
    public Contender own(String method) {
        return new Contender(method, base.shadowSamples(), false);
    }

    /** Everything that must be the same where a trade goes on, one {@code key=value} per line. */
    List<String> identity() {
        RenderSettings.Crop c = base.region();
        return List.of(
                "format=2",
                "scene=" + sceneKey,
                "methods=" + String.join(",", methods),
                "size=" + base.width() + "x" + base.height(),
                "crop=" + c.x() + "," + c.y() + "," + c.width() + "," + c.height(),
                "antialias=" + base.antialias(),
                "shadowSamples=" + base.shadowSamples(),
                "proposal=" + base.proposal(),
                "seed=" + base.seed(),
                "threads=" + base.threads(),
                "reference="
                        + reference
                                .map(r -> "given, " + Arrays.hashCode(r.toArray()))
                                .orElse("auto"));
    }
}

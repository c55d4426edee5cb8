package enlightenment.cli.measure;

import enlightenment.measure.analysis.CostEstimate;
import enlightenment.measure.analysis.EqualErrorComparison;
import enlightenment.measure.analysis.TradeAnalysis;
import enlightenment.render.RenderRequest;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The choice of the automatic method for a scene that was measured, and how good it is. */
final class AutomaticChoice {
    /** Times that differ by less count as alike. */
    private static final double ALIKE = 1.1;

    private AutomaticChoice() {}

    /** A sentence about the smallest error at which methods were compared; empty if they were at none, or only one can render the scene. */
    static Optional<String> sentence(Scene scene, TradeAnalysis measured, BooleanSupplier cancelled) {
        List<EqualErrorComparison> all = EqualErrorComparison.all(measured).stream()
                .filter(EqualErrorComparison::best)
                .toList();
        if (all.isEmpty()) {
            return Optional.empty();
        }
        EqualErrorComparison there = all.get(all.size() - 1);
        RenderSettings settings = measured.settings().base().withMethod(Method.AUTO);
        RenderRequest.MethodChoice choice = Renderer.choose(
                scene, settings.withBudget(RenderSettings.Budget.NONE.withError(there.error())), cancelled);
        String word = choice.settings().method().word();
        return Optional.of(String.format(
                Locale.ROOT,
                "At an error of %.2g --method %s comes to %s, %s.",
                there.error(),
                Method.AUTO.word(),
                word,
                judged(there, word)));
    }

    private static String judged(EqualErrorComparison there, String word) {
        Optional<CostEstimate> cost =
                there.costs().stream().filter(c -> c.method().equals(word)).findFirst();
        if (cost.isEmpty()) {
            return "which was not measured there";
        }
        double times = there.timesAsLong(cost.get());
        return times < ALIKE
                ? "the fastest of those measured"
                : String.format(
                        Locale.ROOT,
                        "which takes %.1f times as long as %s",
                        times,
                        there.fastest().method());
    }
}

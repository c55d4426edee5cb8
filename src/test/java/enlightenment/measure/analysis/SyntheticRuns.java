package enlightenment.measure.analysis;

import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import enlightenment.measure.trade.TradeRun;
import enlightenment.measure.trade.TradeSettings;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Runs whose time and error are known. */
public final class SyntheticRuns {
    /** Light samples of the synthetic scene. */
    public static final int LIGHT_SAMPLES = 10;

    private SyntheticRuns() {}

    public static TradeRun run(String method, double samples, long seed, double meanSquaredDifference, double wall) {
        double e = Math.sqrt(meanSquaredDifference);
        return of(TradeRun.BUDGET_SERIES, method, LIGHT_SAMPLES, samples, seed, meanSquaredDifference, wall, e);
    }

    /** A run without a reference's error in it; FLIP as given. */
    public static TradeRun of(
            String kind,
            String method,
            int lightSamples,
            double samples,
            long seed,
            double meanSquaredDifference,
            double wall,
            double flip) {
        double e = Math.sqrt(meanSquaredDifference);
        return new TradeRun(
                kind,
                method,
                4,
                lightSamples,
                2,
                samples,
                seed,
                wall,
                2 * wall,
                samples == 0 ? 16 : samples,
                meanSquaredDifference,
                flip,
                e,
                0.9 * e,
                1.1 * e);
    }

    /**
     * Budgets of 1, 2, 4, ... samples: error and FLIP fall with the root of the samples, time grows with them.
     *
     * @param error with one sample
     * @param seconds with one sample
     */
    public static List<TradeRun> series(
            String method, int lightSamples, int most, double error, double flip, double seconds) {
        List<TradeRun> runs = new ArrayList<>();
        for (int n = 1; n <= most; n *= 2) {
            double root = Math.sqrt(n);
            runs.add(of(
                    TradeRun.BUDGET_SERIES, method, lightSamples, n, 1, error * error / n, seconds * n, flip / root));
        }
        return runs;
    }

    /** The analysis of a comparison of any methods, of which some cannot see all of the scene; no error in the reference. */
    public static TradeAnalysis trade(List<String> methods, Map<String, String> blindSpots, List<TradeRun> runs) {
        return TradeAnalysis.of(new TradeResult(
                settings().withMethods(methods),
                new Reference(Optional.empty(), 0, List.of()),
                runs,
                new TradeResult.Conditions(Map.of(), 0, 1, true),
                blindSpots));
    }

    /** The analysis of a comparison of both methods with 10 light samples, given these runs. */
    public static TradeAnalysis trade(double referenceError, List<TradeRun> runs) {
        return TradeAnalysis.of(new TradeResult(
                settings(),
                new Reference(Optional.empty(), referenceError * referenceError, List.of()),
                runs,
                new TradeResult.Conditions(Map.of(), 0, 1, true),
                Map.of()));
    }

    public static TradeSettings settings() {
        RenderSettings base = new RenderSettings(
                Method.RAYTRACE,
                8,
                8,
                Optional.empty(),
                4,
                RenderSettings.Budget.NONE,
                ChosenSettings.of(new BuiltInMethod.RayTraceSettings(LIGHT_SAMPLES)),
                2,
                8);
        return new TradeSettings(
                Shading.Model.CLASSIC,
                base,
                List.of("raytrace", "cluster"),
                1,
                1,
                List.of(),
                Optional.empty(),
                "a scene");
    }
}

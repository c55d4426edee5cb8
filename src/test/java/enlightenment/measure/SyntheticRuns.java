package enlightenment.measure;

import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Runs whose time and error are known. */
final class SyntheticRuns {
    /** What the synthetic scene asks for. */
    static final int LIGHT_POINTS = 10;

    private SyntheticRuns() {}

    static TradeRun run(String method, double samples, long seed, double meanSquaredDifference, double wall) {
        double e = Math.sqrt(meanSquaredDifference);
        return of(TradeRun.LADDER, method, LIGHT_POINTS, samples, seed, meanSquaredDifference, wall, e);
    }

    /** A run without a reference's error in it; FLIP as given. */
    static TradeRun of(
            String kind,
            String method,
            int lightPoints,
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
                lightPoints,
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
     * A ladder of 1, 2, 4, ... samples: error and FLIP fall with the root of the samples, time grows with them.
     *
     * @param error with one sample
     * @param seconds with one sample
     */
    static List<TradeRun> ladder(String method, int lightPoints, int most, double error, double flip, double seconds) {
        List<TradeRun> runs = new ArrayList<>();
        for (int n = 1; n <= most; n *= 2) {
            double root = Math.sqrt(n);
            runs.add(of(TradeRun.LADDER, method, lightPoints, n, 1, error * error / n, seconds * n, flip / root));
        }
        return runs;
    }

    /** A trade of both methods with 10 light points, given these runs. */
    static TradeResult trade(double referenceError, List<TradeRun> runs, List<EqualTime> pictures) {
        return TradeResult.of(
                settings(),
                new Reference(Optional.empty(), referenceError * referenceError, List.of()),
                runs,
                pictures,
                new Circumstances(Map.of(), 0, 1, true));
    }

    static TradeSettings settings() {
        RenderSettings base = new RenderSettings(
                Method.RAYTRACE, 8, 8, Optional.empty(), 4, LIGHT_POINTS, 0, Budget.NONE, "normal", 2, 8);
        return new TradeSettings(base, List.of("raytrace", "cluster"), 1, 1, List.of(), Optional.empty(), "a scene");
    }
}

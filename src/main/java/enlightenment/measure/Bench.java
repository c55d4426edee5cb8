package enlightenment.measure;

import enlightenment.check.Check;
import enlightenment.measure.trade.Spread;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * The render time of one scene, measured by repeated renders after a warm-up.
 *
 * @param name name of the measurement in the output
 * @param settings the settings of the renders
 * @param wall seconds by the clock for one render, from the scene in memory to the finished image
 * @param cpu seconds of all processors for one render; 0 where the system does not report it
 * @param rays rays of all kinds that one render traced
 * @param lightSamples light samples that one render evaluated, with or without a ray; the paper's program counted them as rays
 */
public record Bench(String name, RenderSettings settings, Spread wall, Spread cpu, long rays, long lightSamples) {
    /** The settings of the paper's benchmark, {@code runners.Benchmark}. */
    private static final int PAPER_WIDTH = 400;

    private static final int PAPER_HEIGHT = 200;
    private static final int PAPER_ANTIALIAS = 2;
    private static final int PAPER_SHADOW_SAMPLES = 5;
    private static final int PAPER_THREADS = 12;

    private static final double NANO = 1e-9;

    /** The warm-up lasts at least this many seconds. */
    private static final double WARM_UP = 2;

    /** Seconds after which no measured render begins, except the first. */
    private static final double MAX_SECONDS = 20;

    /** The settings of the paper's benchmark, for its scene fire and ice; other settings are the scene's own. */
    public static RenderSettings paperSettings(Scene fireAndIce) {
        return RenderSettings.of(fireAndIce)
                .using(new BuiltInMethod.RayTraceSettings(PAPER_SHADOW_SAMPLES))
                .withSize(PAPER_WIDTH, PAPER_HEIGHT)
                .withAntialias(PAPER_ANTIALIAS)
                .withThreads(PAPER_THREADS);
    }

    /**
     * Renders repeatedly and measures the time. Warm-up and measurement take 2 to 22 seconds, or as long as two renders.
     *
     * @param name the name of the measurement
     * @param repeats number of measured renders, at least 1; fewer are made if they take long
     * @param cancelled polled often, by several threads; once it returns true, no further render counts
     * @return the measurement; empty if it was cancelled before the first render ended
     * @throws enlightenment.scene.SceneException if the scene cannot be rendered
     * @throws enlightenment.math.InvalidValueException if {@code repeats} is less than 1
     */
    public static Optional<Bench> run(
            String name, Scene scene, RenderSettings settings, int repeats, BooleanSupplier cancelled) {
        Check.that(repeats >= 1, "repeats", "must be at least 1, not " + repeats);
        long start = System.nanoTime();
        do {
            if (!Renderer.render(scene, settings, RenderProgress.NONE, cancelled)
                    .complete()) {
                return Optional.empty();
            }
        } while (seconds(start) < WARM_UP);
        List<Double> wall = new ArrayList<>();
        List<Double> cpu = new ArrayList<>();
        RenderReport report = null;
        start = System.nanoTime();
        while (wall.size() < repeats && (wall.isEmpty() || seconds(start) < MAX_SECONDS)) {
            long before = System.nanoTime();
            RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, cancelled);
            double took = seconds(before);
            if (!result.complete()) {
                break;
            }
            report = result.report();
            wall.add(took);
            cpu.add(report.phases().stream()
                    .mapToDouble(RenderReport.Phase::cpuSeconds)
                    .sum());
        }
        return report == null
                ? Optional.empty()
                : Optional.of(new Bench(
                        name, settings, Spread.of(wall), Spread.of(cpu), report.rays(), report.lightSamples()));
    }

    /** Facts that times depend on, by label: processor, system, Java, and current load of this machine. */
    public static Map<String, String> machine() {
        return MachineDescription.facts();
    }

    private static double seconds(long since) {
        return (System.nanoTime() - since) * NANO;
    }

    /** Rays of all kinds per second by the clock, from the median time. */
    public double raysPerSecond() {
        return rays / wall.median();
    }

    /** Light samples per second by the clock, from the median time: the paper's figure. */
    public double lightSamplesPerSecond() {
        return lightSamples / wall.median();
    }
}

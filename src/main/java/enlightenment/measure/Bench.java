package enlightenment.measure;

import enlightenment.render.RenderProgress;
import enlightenment.render.RenderReport;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * How fast one scene is rendered.
 *
 * @param name what it is called in the output
 * @param settings the settings in force
 * @param wall seconds by the clock of each render, from scene description to picture
 * @param cpu seconds of all processors
 * @param rays rays of all kinds that were traced in one render
 * @param lightSamples light points that were asked for in one render: what the paper's program counted as rays
 */
public record Bench(String name, RenderSettings settings, Spread wall, Spread cpu, long rays, long lightSamples) {
    /** The paper's benchmark, {@code runners.Benchmark}: fire and ice with these settings. */
    private static final int PAPER_WIDTH = 400;

    private static final int PAPER_HEIGHT = 200;
    private static final int PAPER_ANTIALIAS = 2;
    private static final int PAPER_SHADOW_SAMPLES = 5;
    private static final int PAPER_THREADS = 12;

    private static final double NANO = 1e-9;

    /** Renders for nothing go on for so many seconds, and those that count for at most so many. */
    private static final double WARM_UP = 2;

    private static final double LONGEST = 20;

    /** The settings of the paper's benchmark. */
    public static RenderSettings paperSettings(Scene fireAndIce) {
        return RenderSettings.of(fireAndIce)
                .withMethod(Method.RAYTRACE)
                .withSize(PAPER_WIDTH, PAPER_HEIGHT)
                .withAntialias(PAPER_ANTIALIAS)
                .withShadowSamples(PAPER_SHADOW_SAMPLES)
                .withThreads(PAPER_THREADS);
    }

    /**
     * Renders again and again, warm, and takes the time.
     *
     * @param repeats how many renders count, at least 1; fewer where they take long
     * @return nothing where it was cancelled before one was finished
     */
    public static Optional<Bench> run(
            String name, Scene scene, RenderSettings settings, int repeats, BooleanSupplier cancelled) {
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
        while (wall.size() < repeats && (wall.isEmpty() || seconds(start) < LONGEST)) {
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

    private static double seconds(long since) {
        return (System.nanoTime() - since) * NANO;
    }

    /** Rays of all kinds per second by the clock, in the median. */
    public double raysPerSecond() {
        return rays / wall.median();
    }

    /** The paper's figure: light points per second by the clock, in the median. */
    public double lightSamplesPerSecond() {
        return lightSamples / wall.median();
    }
}

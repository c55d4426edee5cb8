package enlightenment.measure;

import enlightenment.image.Flip;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderReport;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.function.BooleanSupplier;

/** Renders with a stopwatch, and judges what came out. */
final class Meter {
    private static final double NANO = 1e-9;

    private final Scene scene;
    private final BooleanSupplier cancelled;
    private final RenderProgress tick;

    /** @param tick hears now and then that time passes */
    Meter(Scene scene, BooleanSupplier cancelled, Runnable tick) {
        this.scene = scene;
        this.cancelled = cancelled;
        this.tick = (done, total, soFar) -> tick.run();
    }

    /** A render and how long it took. */
    record Timed(Image image, RenderSettings settings, double wall, double cpu, RenderReport.Sampling sampling) {}

    /** Renders; throws {@link Stopped} if that was not brought to its end. */
    Timed render(RenderSettings settings) {
        if (cancelled.getAsBoolean()) {
            throw new Stopped();
        }
        long start = System.nanoTime();
        RenderResult result = Renderer.render(scene, settings, tick, cancelled);
        double wall = (System.nanoTime() - start) * NANO;
        if (!result.complete()) {
            throw new Stopped();
        }
        double cpu = result.report().phases().stream()
                .mapToDouble(RenderReport.Phase::cpuSeconds)
                .sum();
        return new Timed(result.image(), settings, wall, cpu, result.report().sampling());
    }

    /** Compares some renders with the reference, side by side in time: nothing is being timed meanwhile. */
    static List<TradeRun> judge(String kind, List<Timed> renders, Image reference) {
        return renders.parallelStream().map(r -> judge(kind, r, reference)).toList();
    }

    private static TradeRun judge(String kind, Timed r, Image reference) {
        RenderSettings s = r.settings;
        return new TradeRun(
                kind,
                s.method().word(),
                s.antialias(),
                s.shadowSamples(),
                s.threads(),
                s.budget().samples().orElse(0),
                s.seed(),
                r.wall,
                r.cpu,
                r.sampling.samplesPerPixel(),
                ImageError.between(r.image, reference).meanSquaredError(),
                Flip.between(r.image, reference).mean(),
                r.sampling.estimatedError(),
                r.sampling.errorLow(),
                r.sampling.errorHigh());
    }
}

package enlightenment.measure;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageError;
import enlightenment.image.flip.Flip;
import enlightenment.measure.trade.TradeRun;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;

/** Renderer that measures times and compares pictures with the reference. */
final class TimedRenderer {
    private static final double NANO = 1e-9;

    private final Scene scene;
    private final BooleanSupplier cancelled;
    private final RenderProgress tick;

    /** @param tick called often while time passes, one call at a time */
    TimedRenderer(Scene scene, BooleanSupplier cancelled, Runnable tick) {
        this.scene = scene;
        this.cancelled = cancelled;
        this.tick = (done, total, soFar) -> tick.run();
    }

    /** A render with its times in seconds. */
    record Timed(Image image, RenderSettings settings, double wall, double cpu, RenderReport.Sampling sampling) {}

    /** Reads a picture of the scene that was kept in a file. */
    Image read(Path file) throws IOException {
        return StoredPicture.read(scene, file);
    }

    /** Renders; throws {@link CancelledException} if the render was cancelled. */
    Timed render(RenderSettings settings) {
        if (cancelled.getAsBoolean()) {
            throw new CancelledException();
        }
        long start = System.nanoTime();
        RenderResult result = Renderer.render(scene, settings, tick, cancelled);
        double wall = (System.nanoTime() - start) * NANO;
        if (!result.complete()) {
            throw new CancelledException();
        }
        double cpu = result.report().phases().stream()
                .mapToDouble(RenderReport.Phase::cpuSeconds)
                .sum();
        return new Timed(result.image(), settings, wall, cpu, result.report().sampling());
    }

    /** Compares renders with the reference, in display units and in parallel, as nothing is timed meanwhile. */
    static List<TradeRun> judge(String kind, List<Timed> renders, Image reference) {
        Image shown = reference.toDisplay();
        return renders.parallelStream().map(r -> judge(kind, r, shown)).toList();
    }

    private static TradeRun judge(String kind, Timed r, Image reference) {
        Image shown = r.image.toDisplay();
        RenderSettings s = r.settings;
        return new TradeRun(
                kind,
                s.method().word(),
                s.antialias(),
                r.image.encoding() == Color.Encoding.LINEAR
                        ? 0
                        : BuiltInMethod.RayTraceSettings.of(s).shadowSamples(),
                s.threads(),
                s.budget().samples().orElse(0),
                s.seed(),
                r.wall,
                r.cpu,
                r.sampling.samplesPerPixel(),
                ImageError.between(shown, reference).meanSquaredError(),
                Flip.between(shown, reference).mean(),
                r.sampling.estimatedError(),
                r.sampling.errorLow(),
                r.sampling.errorHigh());
    }
}

package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.SplatBatch;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.CausticTracer;
import java.util.function.BooleanSupplier;

/**
 * The caustics of a picture of which tiles make the rest: paths from lights that are aimed at mirrors and smooth glass
 * (docs/caustics.md).
 */
public final class CausticPaths implements SplatIntegrator {
    /** Paths that tell how bright their light is in the picture. */
    private static final int TRIAL_PATHS = 1 << 12;

    private final CausticTracer tracer;

    /** For one thread, and a scene with a pass of caustics. */
    public CausticPaths(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        tracer = new CausticTracer(scene, settings.seed(), settings.width(), settings.height(), counters);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        tracer.stopWhen(cancelled);
    }

    @Override
    public void trace(long firstPath, int paths, SplatBatch out) {
        for (int i = 0; i < paths; i++) {
            tracer.trace(firstPath + i, out);
        }
    }

    @Override
    public double expectedContribution() {
        return tracer.meanContribution(TRIAL_PATHS);
    }
}

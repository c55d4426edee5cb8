package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.SplatBatch;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.LightTracer;
import java.util.function.BooleanSupplier;

/**
 * Light tracing: paths from everything that shines make all light that surfaces scatter to the eye. What the eye sees of lights, straight
 * and in mirrors, is the business of tiles beside it ({@link RayTraceMethod#ofSeenLight}). See docs/light-tracing.md.
 */
public final class LightPaths implements SplatIntegrator {
    /** Paths that tell how bright their light is in the picture. */
    private static final int TRIAL_PATHS = 1 << 12;

    private final LightTracer tracer;

    /** For one thread, and a scene of physical shading. */
    public LightPaths(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        tracer = new LightTracer(scene, settings.seed(), settings.width(), settings.height(), counters);
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

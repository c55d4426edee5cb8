package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.SplatBatch;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.BidirectionalLightTracer;
import java.util.function.BooleanSupplier;

/** Of {@link BidirectionalMethod} the light paths that are connected to the eye itself. */
public final class BidirectionalPaths implements SplatIntegrator {
    /** Paths that tell how bright their light is in the picture. */
    private static final int TRIAL_PATHS = 1 << 12;

    private final BidirectionalLightTracer tracer;

    /** For one thread, and a scene of physical shading. */
    public BidirectionalPaths(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        tracer = new BidirectionalLightTracer(scene, settings.seed(), settings.width(), settings.height(), counters);
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

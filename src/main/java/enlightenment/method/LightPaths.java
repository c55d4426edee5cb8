package enlightenment.method;

import enlightenment.compiled.ChanceLight;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.SplatBatch;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.ChanceProbe;
import enlightenment.shading.LightPathTracer;
import java.util.function.BooleanSupplier;

/** Paths from lights whose light is added to what tiles make of the same picture. */
public final class LightPaths implements SplatIntegrator {
    /** Paths that tell how bright their light is in the picture. */
    private static final int TRIAL_PATHS = 1 << 12;

    private final LightPathTracer tracer;

    private LightPaths(LightPathTracer tracer) {
        this.tracer = tracer;
    }

    /**
     * The caustics of a picture of which tiles make the rest: paths that are aimed at mirrors and smooth glass (docs/caustics.md). For one
     * thread, and a scene with a pass of caustics.
     */
    public static LightPaths ofCaustics(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(
                LightPathTracer.ofCaustics(scene, settings.seed(), settings.width(), settings.height(), counters));
    }

    /**
     * Light tracing: paths from everything that shines make all light that surfaces scatter to the eye. What the eye sees of lights,
     * straight and in mirrors, is the business of tiles ({@link RayTraceMethod#ofSeenLight}). See docs/light-tracing.md. For one thread, and
     * a scene of physical shading.
     */
    public static LightPaths ofAllLight(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(
                LightPathTracer.ofAllLight(scene, settings.seed(), settings.width(), settings.height(), counters));
    }

    /**
     * Of {@link BidirectionalMethod} the light paths that are connected to the eye itself. For one thread, and a scene of physical
     * shading.
     */
    public static LightPaths ofBidirectional(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(
                LightPathTracer.ofBidirectional(scene, settings.seed(), settings.width(), settings.height(), counters));
    }

    /**
     * What paths from the eye find by chance only, since paths from lights cannot be connected to the eye where it is seen: caustics in mirrors
     * and through glass; null if nothing is known to be left so. Found out once for a scene of physical shading.
     */
    public static ChanceLight leftToChance(CompiledScene scene) {
        return scene.chanceLight(() -> ChanceProbe.find(scene));
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

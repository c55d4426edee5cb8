package enlightenment.method;

import enlightenment.film.SplatBatch;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.light.LightPathTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * Light paths whose splats are added to the tiles of the same picture. Where the picture is the mean of several moments, each path sees one
 * of them ({@link Moments}).
 */
public final class LightPaths implements SplatIntegrator {
    /**
     * The number of paths per moment, at least, by which the mean contribution is estimated; it need be right only up to a factor that sums
     * have room for.
     */
    private static final int TRIAL_PATHS = 1 << 9;

    private static final int TRIAL_PATHS_OF_MOMENT = 1 << 6;

    /** One tracer for each moment; null where there are no paths. */
    private final LightPathTracer[] tracers;

    private final Moments moments;

    /** The hash from which all paths' moments follow. */
    private final long lots;

    /** Makes the tracer of a moment. */
    private interface Tracers {
        LightPathTracer of(CompiledScene moment, long seed, int width, int height, RayCounters counters);
    }

    private LightPaths(CompiledScene scene, RenderSettings settings, RayCounters counters, Tracers of) {
        CompiledScene[] scenes = scene.moments();
        tracers = new LightPathTracer[scenes.length];
        for (int i = 0; i < scenes.length; i++) {
            RayCounters own = scene.countersOf(scenes[i], counters);
            tracers[i] = of.of(scenes[i], settings.seed(), settings.width(), settings.height(), own);
        }
        moments = new Moments(scenes.length);
        lots = Hash.of(settings.seed(), Moments.PURPOSE);
    }

    /**
     * Makes the caustics of a picture whose other light tiles estimate: light paths aimed at mirrors and smooth glass
     * (docs/notes/caustics.md). For one thread, and a scene with a caustic pass ({@link CompiledScene#hasCausticPass}).
     */
    public static LightPaths ofCaustics(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(
                scene,
                settings,
                counters,
                (moment, seed, width, height, counted) -> moment.physical.hasCausticPass()
                        ? LightPathTracer.ofCaustics(moment, seed, width, height, counted)
                        : null);
    }

    /**
     * Makes the light paths of light tracing: all light that surfaces scatter to the eye. Emission that the eye sees, directly and in
     * mirrors, is left to tiles ({@link RayTraceMethod#ofSeenLight}). See docs/notes/light-tracing.md. For one thread, and a scene of
     * physical shading.
     */
    public static LightPaths ofAllLight(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(scene, settings, counters, LightPathTracer::ofAllLight);
    }

    /**
     * Makes the light paths of {@link BidirectionalMethod} that are connected to the eye itself. For one thread, and a scene of physical
     * shading.
     */
    public static LightPaths ofBidirectional(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new LightPaths(scene, settings, counters, LightPathTracer::ofBidirectional);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        for (LightPathTracer tracer : tracers) {
            if (tracer != null) {
                tracer.stopWhen(cancelled);
            }
        }
    }

    @Override
    public void trace(long firstPath, int paths, SplatBatch out) {
        if (tracers.length == 1) {
            for (int i = 0; i < paths; i++) {
                tracers[0].trace(firstPath + i, out);
            }
            return;
        }
        for (int i = 0; i < paths; i++) {
            LightPathTracer tracer = tracers[moments.of(lots, firstPath + i)];
            if (tracer != null) {
                tracer.trace(firstPath + i, out);
            }
        }
    }

    @Override
    public double expectedContribution() {
        int paths = Math.max(TRIAL_PATHS / tracers.length, TRIAL_PATHS_OF_MOMENT);
        double sum = 0;
        for (LightPathTracer tracer : tracers) {
            sum += tracer == null ? 0 : tracer.meanContribution(paths);
        }
        return sum / tracers.length;
    }
}

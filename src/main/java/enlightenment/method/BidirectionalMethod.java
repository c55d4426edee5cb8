package enlightenment.method;

import enlightenment.scene.RenderSettings;
import enlightenment.transport.bidirectional.BidirectionalTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Bidirectional path tracing (docs/notes/bidirectional.md). Tiles take camera samples as {@link RayTraceMethod} does, and connect each with
 * a light path of its own; the splats of other light paths, connected to the eye itself, are added ({@link LightPaths#ofBidirectional}).
 */
public final class BidirectionalMethod {
    /** The number of light paths connected to the eye per camera sample; all MIS weights assume it. */
    public static final double PATHS_PER_SAMPLE = BidirectionalTracer.LIGHT_PATHS_PER_SAMPLE;

    private BidirectionalMethod() {}

    /**
     * Makes the tile integrator of one thread.
     *
     * @param scene whose shading is physical
     * @param samples per pixel in the mean, as for {@link RayTraceMethod}
     */
    public static RayTraceMethod of(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return RayTraceMethod.of(scene, settings, counters, samples, BidirectionalTracer::new);
    }
}

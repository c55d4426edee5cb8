package enlightenment.method;

import enlightenment.scene.RenderSettings;
import enlightenment.transport.bidirectional.BidirectionalTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Paths from both ends (docs/notes/bidirectional.md). Tiles take camera samples as {@link RayTraceMethod} does, and connect each with a light
 * path of its own; what other light paths bring to the eye straight is added to them ({@link LightPaths#ofBidirectional}).
 */
public final class BidirectionalMethod {
    /** Paths that may end anywhere, per camera sample: the weights of all paths count on it. */
    public static final double PATHS_PER_SAMPLE = BidirectionalTracer.LIGHT_PATHS_PER_SAMPLE;

    private BidirectionalMethod() {}

    /**
     * What makes the tiles, for one thread.
     *
     * @param scene whose shading is physical
     * @param samples per pixel in the mean, as {@link RayTraceMethod} wants it
     */
    public static RayTraceMethod of(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return RayTraceMethod.of(scene, settings, counters, samples, BidirectionalTracer::new);
    }
}

package enlightenment.transport.light;

import enlightenment.sampling.Hash;
import enlightenment.transport.emission.LightSource;
import enlightenment.transport.path.SeenLight;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Follows light from everything that shines to all surfaces that scatter it other than into single directions, and connects it to the eye
 * at each of them: everything but what {@link SeenLight} finds, and what is seen in mirrors or through glass that turns rays.
 */
public final class LightTracer extends LightWalker {
    /** Keeps the numbers of these paths apart from all others. */
    private static final long PURPOSE = 0x6c696768747061L;

    /**
     * For one thread.
     *
     * @param scene whose shading is physical
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters what this thread counts
     */
    LightTracer(CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        super(
                scene,
                new LightSource(scene.lightStarts(true), scene.physical),
                false,
                Hash.of(seed, PURPOSE),
                width,
                height,
                counters);
    }
}

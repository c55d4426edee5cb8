package enlightenment.transport.light;

import enlightenment.sampling.Hash;
import enlightenment.transport.emission.LightSource;
import enlightenment.transport.path.SeenLight;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Traces light paths from all emitters, and connects each vertex at which a lobe other than a delta lobe scatters light to the eye:
 * everything but the light of {@link SeenLight}, and what is seen in mirrors or through glass that refracts.
 */
public final class LightTracer extends LightWalker {
    /** Mixed into the seed, so that these paths share no random numbers with others. */
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

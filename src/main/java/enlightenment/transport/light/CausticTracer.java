package enlightenment.transport.light;

import enlightenment.sampling.Hash;
import enlightenment.transport.emission.CausticSource;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Traces light paths over mirrors and smooth glass to the surfaces on which they make caustics, and on from there; each of these vertices
 * is connected to the eye. Paths from the eye sample such light badly, and leave it out ({@link PathIntegrator}).
 */
public final class CausticTracer extends LightWalker {
    /** Mixed into the seed, so that these paths share no random numbers with others. */
    private static final long PURPOSE = 0x6361757374696373L;

    /**
     * For one thread.
     *
     * @param scene whose shading is physical, with a pass of caustics
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters what this thread counts
     */
    public CausticTracer(CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        super(scene, new CausticSource(scene.physical.caustics), true, Hash.of(seed, PURPOSE), width, height, counters);
    }
}

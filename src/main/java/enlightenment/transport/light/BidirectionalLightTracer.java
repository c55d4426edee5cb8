package enlightenment.transport.light;

import enlightenment.bsdf.Scattering;
import enlightenment.sampling.Sampler;
import enlightenment.transport.bidirectional.BidirectionalTracer;
import enlightenment.transport.bidirectional.LightSubpath;
import enlightenment.transport.bidirectional.PathSampler;
import enlightenment.transport.bidirectional.ReverseDensity;
import enlightenment.transport.bidirectional.Strategies;
import enlightenment.transport.bidirectional.SubpathDensities;
import enlightenment.transport.state.PathWavelength;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/**
 * Light paths connected to the eye: the one strategy of {@link BidirectionalTracer} that may splat anywhere on the film. Its paths are
 * independent of those that tiles follow, with the same densities.
 */
public final class BidirectionalLightTracer extends LightPathTracer {
    private final LightSubpath light;
    private final ReverseDensity reverse = new ReverseDensity();
    private final PathSampler sampler;
    private final double[] pair = new double[2];

    /** See {@link SubpathDensities}. */
    private final double areaUnit;

    /** Observes the strategies in tests; else null. */
    private Strategies strategies;

    /**
     * For one thread.
     *
     * @param scene whose shading is physical
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     */
    public BidirectionalLightTracer(CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        this(scene, new LightSubpath(scene, scene.lightStarts(false), counters), seed, width, height, counters);
    }

    private BidirectionalLightTracer(
            CompiledScene scene, LightSubpath light, long seed, int width, int height, RayCounters counters) {
        super(scene, light.path, width, height, counters);
        this.light = light;
        sampler = new PathSampler(seed);
        areaUnit = scene.physical.areaUnit;
    }

    /** Sets an observer of strategies, for tests. */
    public void watch(Strategies by) {
        strategies = by;
    }

    /** The last light subpath. */
    public LightSubpath light() {
        return light;
    }

    @Override
    double power() {
        return light.power();
    }

    @Override
    boolean follow(long number) {
        sampler.path(number);
        boolean begins = light.begin(sampler);
        boolean goes = begins;
        while (goes) {
            goes = switch (light.next(sampler)) {
                case SURFACE, INTERFACE, MEDIUM -> light.mayScatter() && scatter();
                case PASSED -> true;
                case NOTHING, ENDED -> false;
            };
        }
        return begins;
    }

    private boolean scatter() {
        if (!light.bsdf.isDelta()) {
            connect();
        }
        return light.leave(sampler);
    }

    /** Connects the current surface of the light subpath to the eye. */
    private void connect() {
        Scattering s = light.s;
        if (eye.hasSeveralStarts()) {
            sampler.pair(light.state.address, Sampler.Purpose.LIGHT_LENS, pair);
            eye.sampleStart(pair[0], pair[1]);
        }
        if (!isSeen(light.bsdf, s, light.isInterface ? light.color : null)) {
            return;
        }
        double weight = weight(light.projected(s.geometricCosineIn()));
        int vertices = light.vertices.size() + 1;
        double f = eye.importance() * (strategies == null ? weight : strategies.weight(vertices, 1, weight));
        PathWavelength wavelength = light.path.glass.wavelength;
        if (wavelength != null && wavelength.colors(light.isInterface)) {
            s.valueR *= wavelength.red;
            s.valueG *= wavelength.green;
            s.valueB *= wavelength.blue;
        }
        add(
                f * eye.through[0] * s.valueR * light.throughput.red,
                f * eye.through[1] * s.valueG * light.throughput.green,
                f * eye.through[2] * s.valueB * light.throughput.blue);
    }

    private double weight(double cosine) {
        double seen = eye.importance() * areaUnit * cosine / BidirectionalTracer.LIGHT_PATHS_PER_SAMPLE;
        double back = light.survival * reverse.of(light.bsdf, light.s);
        return SubpathDensities.weight(SubpathDensities.square(seen) * light.densities.behind(back), 0);
    }
}

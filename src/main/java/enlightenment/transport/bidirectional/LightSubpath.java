package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Reradiation;
import enlightenment.emitter.SampledLight;
import enlightenment.primitive.Hit;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.LightView;
import enlightenment.transport.emission.LightSource;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.PathSource;
import enlightenment.transport.state.Throughput;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;

/** The subpath that begins at a light. */
public final class LightSubpath extends Subpath {
    final LightSource source;

    /** The origin of the subpath, in the frame. */
    double startX;

    double startY;
    double startZ;

    private final LightView view = new LightView();
    private final SampledLight scratch = new SampledLight();
    private final double[] numbers = new double[PathSource.NUMBERS];
    private final double[] pair = new double[2];

    public LightSubpath(CompiledScene scene, LightStarts starts, RayCounters counters) {
        super(
                scene,
                counters,
                new PathFollower(scene, counters, scene.physical.maxBounces),
                new Throughput(),
                Sampler.Purpose.LIGHT_CHOICE,
                Sampler.Purpose.LIGHT_DIRECTION,
                Sampler.Purpose.LIGHT_ROULETTE,
                Sampler.Purpose.LIGHT_FLIGHT);
        source = new LightSource(starts, scene.physical);
    }

    /** Begins at a sampled light; returns whether there is a path. */
    public boolean begin(Sampler sampler) {
        for (int k = 0; k < PathSource.NUMBERS; k += 2) {
            sampler.pair(k / 2, Sampler.Purpose.EMISSION, pair);
            numbers[k] = pair[0];
            numbers[k + 1] = pair[1];
        }
        vertices.clear();
        if (!source.emit(numbers, ray)) {
            return false;
        }
        begin();
        throughput.begin(source.red, source.green, source.blue, source.ultraviolet);
        startX = ray.ox;
        startY = ray.oy;
        startZ = ray.oz;
        path.drawWavelength(sampler);
        path.beginAtLight(ray, source);
        return true;
    }

    /** Traces the subpath to its next vertex and lets it leave there; returns whether it goes on. */
    boolean step(Sampler sampler) {
        return goesOn(next(sampler), sampler);
    }

    /** Lets the subpath leave the vertex of an event; returns whether it goes on. */
    boolean goesOn(Event event, Sampler sampler) {
        return switch (event) {
            case SURFACE, INTERFACE, MEDIUM -> mayScatter() && leave(sampler);
            case PASSED -> true;
            case NOTHING, ENDED -> false;
        };
    }

    /** The power of the path's start, mean of the bands. */
    public double power() {
        return source.power(physical.visibleOfUltraviolet) / 3;
    }

    @Override
    void reradiate(Reradiation by) {
        throughput.reradiate(by, color);
    }

    /** Does nothing: power, unlike radiance, is the same on both sides of an interface. */
    @Override
    void enter(double index) {}

    private double emission() {
        return source.probability * (source.pointDensity * physical.areaUnit) * source.directionDensity;
    }

    private double ofBeyond(double cosine) {
        return source.isPoint() ? 0 : SubpathDensities.square(source.cosine / (emission() * cosine));
    }

    @Override
    void beginDensities(double cosine) {
        Hit at = path.at.hit;
        double nx = isInterface ? 0 : s.nx;
        double ny = isInterface ? 0 : s.ny;
        double nz = isInterface ? 0 : s.nz;
        double aimed = aimed(at) * physical.picker.probability(source.light, at.px, at.py, at.pz, nx, ny, nz, scratch);
        densities.begin(SubpathDensities.square(aimed / (emission() * cosine)), ofBeyond(cosine));
    }

    /**
     * The density, per area at the light times the squared distance, with which next-event estimation at the path's first vertex would
     * sample its origin.
     */
    private double aimed(Hit at) {
        PhysicalLight l = physical.lights[source.light];
        double x = at.px - startX;
        double y = at.py - startY;
        double z = at.pz - startZ;
        double d2 = x * x + y * y + z * z;
        if (l.isPoint) {
            return d2;
        }
        double d = Math.sqrt(d2);
        if (l.isBallOf(path.at.id)) {
            return 0;
        }
        view.aim(l, at.px, at.py, at.pz);
        return l.form.pdf(view.sample, -x / d, -y / d, -z / d, d, source.cosineOutside()) * source.cosine;
    }

    @Override
    void beginDensitiesOfDelta() {
        densities.begin(0, ofBeyond(1));
    }
}

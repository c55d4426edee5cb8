package enlightenment.transport.bidirectional;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.image.EyeImages;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * The radiance along one camera ray, by bidirectional path tracing: an eye subpath and a light subpath are traced, and each vertex of one
 * is connected to each of the other (E. Lafortune and Y. Willems, "Bi-directional path tracing", 1993; E. Veach and L. Guibas,
 * "Bidirectional estimators for light transport", 1994). The strategies that can sample a path are weighted by the power heuristic. The
 * weights include light subpaths connected to the eye, which {@code BidirectionalLightTracer} traces. See docs/notes/bidirectional.md.
 */
public final class BidirectionalTracer implements Shader {
    /** The number of light paths connected to the eye per path from the eye. */
    public static final double LIGHT_PATHS_PER_SAMPLE = 1;

    private final PhysicalScene physical;
    private final EyeSubpath eye;
    private final EyeImages images;
    private final BidirectionalGathering gathering;

    /** For one thread, and a scene of physical shading. */
    public BidirectionalTracer(CompiledScene scene, RayCounters counters) {
        physical = scene.physical;
        eye = new EyeSubpath(scene, counters, LIGHT_PATHS_PER_SAMPLE);
        images = new EyeImages(scene, counters, eye.path, true);
        gathering = new BidirectionalGathering(scene, counters, eye, images);
    }

    /** Sets an observer of strategies, for tests. */
    void watch(Strategies by) {
        gathering.watch(by);
    }

    /** The last light subpath. */
    LightSubpath light() {
        return gathering.light;
    }

    /** The last eye subpath. */
    EyeSubpath eye() {
        return eye;
    }

    /** The strategies of sampling or hitting a light. */
    BidirectionalLights lights() {
        return gathering.lights;
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        eye.path.tracer.beginTile(x0, y0, x1, y1);
        images.beginTile(x0, y0, x1, y1);
    }

    @Override
    public boolean seesNothing() {
        return eye.path.tracer.seesNothing() && physical.hasConstantEnvironment();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        eye.path.poll.stopWhen(condition);
        gathering.light.path.poll.stopWhen(condition);
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        gathering.followLight(sampler);
        eye.begin(ray, sampler);
        images.begin(ray);
        if (images.gather(sampler)) {
            gathering.addSeenLight(images);
        }
        while (gathering.step(sampler)) {}
        eye.value.get(out);
    }

    /**
     * Writes the radiance by connections alone, without sampled or hit lights.
     *
     * @param ofLight random numbers of the light subpath
     */
    void connect(Ray ray, Sampler sampler, Sampler ofLight, double[] out) {
        gathering.followLight(ofLight);
        eye.begin(ray, sampler);
        while (stepToConnect(sampler)) {}
        eye.value.get(out);
    }

    private boolean stepToConnect(Sampler sampler) {
        switch (eye.next(sampler)) {
            case NOTHING, ENDED:
                return false;
            case PASSED:
                return true;
            case SURFACE:
                eye.passDye();
                break;
            default:
                break;
        }
        if (!eye.mayScatter()) {
            return false;
        }
        if (!eye.bsdf.isDelta()) {
            gathering.connect(sampler, eye.vertices.size() + 1);
        }
        return eye.leave(sampler);
    }
}

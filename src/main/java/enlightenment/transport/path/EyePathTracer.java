package enlightenment.transport.path;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.image.EyeImages;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.Shader;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/** The base of tracers that follow a path from each camera ray and return the radiance it gathers. One per thread. */
abstract class EyePathTracer implements Shader {
    final PhysicalScene physical;
    final PathFollower path;
    final PathValue value;

    final PathState state = new PathState();

    /** Emission that the eye sees directly, in pixels that the emitter's image covers in part. */
    final EyeImages images;

    /** The colour of the current surface; after a scattering event the event's weight, by band. */
    final double[] surface = new double[3];

    final double[] pair = new double[2];

    /** The scattering at a rough interface of two media. */
    final Scattering atInterface = new Scattering();

    /**
     * @param scene whose shading is physical
     * @param counters of this thread
     * @param showsLamps whether emission that the eye sees directly is included
     */
    EyePathTracer(CompiledScene scene, RayCounters counters, PathValue value, boolean showsLamps) {
        physical = scene.physical;
        path = new PathFollower(scene, counters, physical.maxBounces);
        this.value = value;
        value.wavelength = path.glass.wavelength;
        images = new EyeImages(scene, counters, path, showsLamps);
    }

    @Override
    public final void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
        images.beginTile(x0, y0, x1, y1);
    }

    /** The images of lamps in the tile, which are sampled apart. */
    public final EyeImages images() {
        return images;
    }

    @Override
    public final boolean seesNothing() {
        return path.tracer.seesNothing() && physical.hasConstantEnvironment();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    /** Begins a path at a camera ray. */
    final void beginPath(Ray ray, Sampler sampler) {
        state.begin();
        path.begin(ray, sampler);
        value.begin(path.glass.indexOfRefraction());
        images.begin(ray);
    }

    /**
     * Crosses the current interface of glass, or is reflected; {@link #surface} becomes the weight of that event.
     *
     * @param choice selects reflection or transmission, 0..1; {@link #pair} selects the direction
     */
    final void cross(Ray ray, double choice) {
        path.glass.choose(choice, pair);
        boolean through = path.cross(ray);
        Arrays.fill(surface, path.glass.weight());
        if (through) {
            path.filter(surface);
        }
        value.enter(path.glass.indexOfRefraction());
    }
}

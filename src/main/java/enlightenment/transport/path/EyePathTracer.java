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

/** Follows paths from the eye, of which each is worth what it gathers on its way. One per thread. */
abstract class EyePathTracer implements Shader {
    final PhysicalScene physical;
    final PathFollower path;
    final PathValue value;

    final PathState state = new PathState();

    /** What the eye sees of lamps in pixels that they do not cover entirely. */
    final EyeImages images;

    /** The colour of the surface that the path is at, then the weight of what happened there. */
    final double[] surface = new double[3];

    final double[] pair = new double[2];

    /** A rough border of two media that the path is at. */
    final Scattering border = new Scattering();

    /**
     * @param scene whose shading is physical
     * @param counters what this thread counts
     * @param showsLamps whether light that comes to the eye straight counts
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
    public final void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    /** Starts a path. */
    final void beginPath(Ray ray, Sampler sampler) {
        state.begin();
        path.begin(ray, sampler);
        value.begin(path.glass.indexOfRefraction());
        images.begin(ray);
    }

    /**
     * At glass the path crosses the border or is reflected; the surface's colour becomes the weight of that.
     *
     * @param choice which of the two, 0..1; {@link #pair} has the direction
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

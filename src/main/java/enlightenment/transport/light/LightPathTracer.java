package enlightenment.transport.light;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.film.SplatBatch;
import enlightenment.transport.bidirectional.BidirectionalTracer;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.path.SeenLight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * Light tracing: traces numbered paths from the lights and connects their vertices to the eye, so that each may splat anywhere in the
 * picture (J. Arvo, "Backward ray tracing", 1986; P. Dutré, E. Lafortune and Y. Willems, 1993). All random numbers of a path are a
 * function of the seed and its number.
 */
public abstract class LightPathTracer {
    final PathFollower path;

    /** Connects the path's current vertex to the eye. */
    final EyeConnection eye;

    private final int width;
    private final int height;

    /** Receives the splats; null if only their sum is wanted. */
    private SplatBatch out;

    private double brought;

    /**
     * @param path follows the paths
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     */
    LightPathTracer(CompiledScene scene, PathFollower path, int width, int height, RayCounters counters) {
        this.path = path;
        this.width = width;
        this.height = height;
        eye = new EyeConnection(scene, counters, path);
    }

    /**
     * Makes the tracer of caustics, for one thread: light that mirrors or smooth glass send to a surface, and all that follows from it.
     * Paths from the eye sample it badly and leave it out ({@link PathIntegrator}).
     *
     * @param scene whose shading is physical, with a caustic pass
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters of this thread
     */
    public static LightPathTracer ofCaustics(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new CausticTracer(scene, seed, width, height, counters);
    }

    /**
     * Makes the tracer of all light that lobes other than delta lobes scatter to the eye: everything but the light of {@link SeenLight},
     * and what is seen in mirrors or through glass that refracts. The other parameters are those of {@link #ofCaustics}.
     *
     * @param scene whose shading is physical
     */
    public static LightPathTracer ofAllLight(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new LightTracer(scene, seed, width, height, counters);
    }

    /**
     * Makes the tracer of one strategy of bidirectional path tracing: light subpaths connected to the eye; see {@link BidirectionalTracer}.
     * The other parameters are those of {@link #ofCaustics}.
     *
     * @param scene whose shading is physical
     */
    public static LightPathTracer ofBidirectional(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new BidirectionalLightTracer(scene, seed, width, height, counters);
    }

    /**
     * Sets the condition of cancellation: once it holds, {@link #trace} soon throws a {@link java.util.concurrent.CancellationException}.
     */
    public final void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    /** Traces the path with this number and adds its splats. */
    public final void trace(long number, SplatBatch to) {
        out = to;
        follow(number);
    }

    /**
     * The mean contribution of a path to the picture ({@link SplatBatch#add}), estimated by this number of separate paths; positive, even
     * if none of them reaches the eye, unless the scene has no light.
     */
    public final double meanContribution(int paths) {
        out = null;
        brought = 0;
        double power = 0;
        for (int i = 1; i <= paths; i++) {
            power += follow(-i) ? power() : 0;
        }
        // In the frame lengths are about 1, and so is the importance of visible points.
        double least = power / (paths * (double) paths);
        return Math.min(Math.max(brought / paths, least), Double.MAX_VALUE);
    }

    /** Traces the path with this number; returns whether there is one. */
    abstract boolean follow(long number);

    /** Roughly the power that the last path began with. */
    abstract double power();

    /**
     * Whether the eye sees the path's light at its current vertex ({@link EyeConnection#sees}), within the part of the picture that is
     * rendered.
     *
     * @param tint of transmitted light at a rough interface; null elsewhere
     */
    final boolean isSeen(Bsdf bsdf, Scattering s, double[] tint) {
        return eye.project()
                && (out == null || out.covers(eye.x() * width, eye.y() * height))
                && eye.sees(bsdf, s, tint);
    }

    /** Adds a splat at the film position of the last connection. */
    final void add(double r, double g, double b) {
        if (out == null) {
            brought += (Math.abs(r) + Math.abs(g) + Math.abs(b)) / 3;
        } else {
            out.add(eye.x() * width, eye.y() * height, r, g, b);
        }
    }
}

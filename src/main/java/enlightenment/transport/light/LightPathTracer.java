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

    /** What the eye sees of the surface that the path is at. */
    final EyeConnection eye;

    private final int width;
    private final int height;

    /** Where light is put; null if only its sum is wanted. */
    private SplatBatch out;

    private double brought;

    /**
     * For one thread.
     *
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
     * Caustics, which paths from the eye find by chance only, and leave out ({@link PathIntegrator}): light that mirrors or smooth glass send
     * to a surface, and all that follows from it. For one thread.
     *
     * @param scene whose shading is physical, with a pass of caustics
     * @param seed of all random numbers
     * @param width of the whole picture in pixels
     * @param height of the whole picture in pixels
     * @param counters what this thread counts
     */
    public static LightPathTracer ofCaustics(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new CausticTracer(scene, seed, width, height, counters);
    }

    /**
     * All light that surfaces scatter to the eye other than into single directions: everything but what {@link SeenLight} finds, and what
     * is seen in mirrors or through glass that turns rays. The parameters are those of {@link #ofCaustics}.
     *
     * @param scene whose shading is physical
     */
    public static LightPathTracer ofAllLight(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new LightTracer(scene, seed, width, height, counters);
    }

    /**
     * Of what paths from both ends make together that which those from lights bring to the eye straight: see {@link BidirectionalTracer}.
     * The parameters are those of {@link #ofCaustics}.
     *
     * @param scene whose shading is physical
     */
    public static LightPathTracer ofBidirectional(
            CompiledScene scene, long seed, int width, int height, RayCounters counters) {
        return new BidirectionalLightTracer(scene, seed, width, height, counters);
    }

    /** Ends {@link #trace} by a {@link java.util.concurrent.CancellationException} soon after this becomes true. */
    public final void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    /** Follows the path with this number and adds what it brings to the picture. */
    public final void trace(long number, SplatBatch to) {
        out = to;
        follow(number);
    }

    /**
     * What a path contributes to the picture in the mean ({@link SplatBatch#add}), by some paths with numbers of their own; positive, even
     * if none of them reaches the eye, unless nothing shines.
     */
    public final double meanContribution(int paths) {
        out = null;
        brought = 0;
        double power = 0;
        for (int i = 1; i <= paths; i++) {
            power += follow(-i) ? power() : 0;
        }
        // In the frame lengths are about 1, and so is the importance of what the eye sees.
        double least = power / (paths * (double) paths);
        return Math.min(Math.max(brought / paths, least), Double.MAX_VALUE);
    }

    /** Follows the path with this number; returns whether there is one. */
    abstract boolean follow(long number);

    /** The power, about, that the path began with. */
    abstract double power();

    /**
     * Whether the eye sees the path's light at the surface that it is at ({@link EyeConnection#sees}), in the part of the picture that is
     * made.
     *
     * @param tint of what passes a rough border; null if the surface is none
     */
    final boolean isSeen(Bsdf bsdf, Scattering s, double[] tint) {
        return eye.project()
                && (out == null || out.covers(eye.x() * width, eye.y() * height))
                && eye.sees(bsdf, s, tint);
    }

    /** Adds what it sees. */
    final void add(double r, double g, double b) {
        if (out == null) {
            brought += (Math.abs(r) + Math.abs(g) + Math.abs(b)) / 3;
        } else {
            out.add(eye.x() * width, eye.y() * height, r, g, b);
        }
    }
}

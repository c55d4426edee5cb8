package enlightenment.transport.state;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * One way in which light reaches a vertex of a path from the eye, with its share in multiple importance sampling. The weight of emission that
 * a path hits by BSDF sampling is the product of all strategies' weights: each says 1 of paths that it does not make, and of each
 * path at most one says anything else. So for every path the shares add up to 1 (docs/notes/path-tracing.md).
 */
public interface PathStrategy {
    /**
     * Adds this strategy's estimate of the light that arrives at a vertex and leaves it towards where the path came from.
     *
     * @param state of the path up to the vertex
     */
    void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value);

    /**
     * The weight, 0 to 1, of emission that the path hits by BSDF sampling: one less the share of this strategy. It depends on the path
     * alone, of which the strategy may have kept what {@link #direct} saw: that must have been called last at the last vertex that is not
     * specular.
     *
     * @param ray by which the path came to it
     * @param light index of the light that was hit; negative if it is none that can be sampled
     */
    double weightOfHit(PathState state, Ray ray, int light);
}

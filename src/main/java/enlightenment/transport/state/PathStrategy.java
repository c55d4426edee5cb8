package enlightenment.transport.state;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * A sampling strategy for light that reaches a vertex of a path from the eye, with its MIS weights. The weight of emission that a path hits
 * by BSDF sampling is the product of {@link #weightOfHit} of all strategies: each returns 1 for paths that it cannot sample, and at most
 * one returns anything else. So for every path the weights of all strategies add up to 1 (docs/notes/path-tracing.md).
 */
public interface PathStrategy {
    /**
     * Adds this strategy's weighted estimate of the light that arrives at a vertex and is scattered towards the path's previous vertex.
     *
     * @param state of the path up to the vertex
     */
    void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value);

    /**
     * The MIS weight, 0 to 1, of emission that the path hits by BSDF sampling: 1 minus the weight of this strategy for the same path. It
     * depends on the path alone; the strategy may have kept data from {@link #direct}, so that must have been called last at the path's
     * last vertex that is not specular.
     *
     * @param ray by which the path came to the emitter
     * @param light index of the light that was hit; negative if no strategy can sample the emitter
     */
    double weightOfHit(PathState state, Ray ray, int light);
}

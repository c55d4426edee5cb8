package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathStrategy;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.world.light.CausticPass;

/**
 * The share of the caustic pass, which makes its paths from the lights (docs/notes/caustics.md): light that mirrors or smooth glass, and narrow lobes
 * of small lights, send to a vertex that can be connected to the eye. Paths from the eye add nothing in its place. Immutable.
 */
public final class CausticPassShare implements PathStrategy {
    private final CausticPass pass;
    private final boolean takesNarrow;

    public CausticPassShare(CausticPass pass) {
        this.pass = pass;
        takesNarrow = pass.takesNarrow();
    }

    /** Whether the pass may sample what this BSDF makes of small lights. */
    public boolean isNarrow(Bsdf bsdf) {
        return takesNarrow && bsdf.isNarrow();
    }

    @Override
    public void direct(PathVertex vertex, PathState state, Sampler sampler, PathValue value) {}

    @Override
    public double weightOfHit(PathState state, Ray ray, int light) {
        if (state.hasDirect || state.nextIsCoincident) {
            return state.leftSmallLights && light >= 0 && pass.takesNarrow(light) ? 0 : 1;
        }
        return light >= 0 && state.isSampledByCausticPass() ? 0 : 1;
    }
}

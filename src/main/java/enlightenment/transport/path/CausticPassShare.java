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
 * The strategy of the caustic pass, whose paths begin at lights (docs/notes/caustics.md): it samples light that mirrors, smooth glass or,
 * of small lights, narrow lobes send to a vertex that can be connected to the eye. Paths from the eye add nothing in its place. Immutable.
 */
public final class CausticPassShare implements PathStrategy {
    private final CausticPass pass;

    public CausticPassShare(CausticPass pass) {
        this.pass = pass;
    }

    /** Whether the caustic pass samples light of small lights that this BSDF reflects. */
    public boolean isNarrow(Bsdf bsdf) {
        return pass.takesNarrow(bsdf);
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

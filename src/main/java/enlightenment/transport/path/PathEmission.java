package enlightenment.transport.path;

import enlightenment.primitive.Ray;
import enlightenment.transport.direct.NextEventEstimation;
import enlightenment.transport.image.EyeImages;
import enlightenment.transport.image.MirrorCaustics;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;

/** Adds emission that a path hits, by lights and by the surroundings, times its MIS weight against all other strategies. One per thread. */
final class PathEmission {
    private final PathFollower path;
    private final PathValue value;
    private final PathState state;
    private final NextEventEstimation nextEvent;
    private final EyeImages images;

    /** Null if the scene has none. */
    private final CausticPassShare causticPass;

    private final MirrorCaustics mirrorCaustics;

    /** Shares the work objects of a path integrator; the last two are null if the scene has none. */
    PathEmission(
            PathFollower path,
            PathValue value,
            PathState state,
            NextEventEstimation nextEvent,
            EyeImages images,
            CausticPassShare causticPass,
            MirrorCaustics mirrorCaustics) {
        this.path = path;
        this.value = value;
        this.state = state;
        this.nextEvent = nextEvent;
        this.images = images;
        this.causticPass = causticPass;
        this.mirrorCaustics = mirrorCaustics;
    }

    /** Adds the surroundings' radiance where the path has left the scene. */
    void escape(Ray ray) {
        nextEvent.escape(ray, state, causticPass == null || !state.isSampledByCausticPass());
        value.addEscaped(nextEvent.gathered, nextEvent.hasConstantEnvironment(), path.key);
    }

    /**
     * Adds the emission of the surface that the path is at.
     *
     * @param cut takes the emission that the sampled direction of a cut path meets; null if the path is not to be cut
     */
    void add(Ray ray, PathCut cut) {
        if (cut != null && cut.isLeft(state) && cut.meets(path.at, value, nextEvent.density(ray))) {
            return;
        }
        double weight = path.at.emits() ? weightOfHit(ray) : 0;
        if (weight > 0) {
            value.addEmission(path.at, weight, path.key);
        }
    }

    private double weightOfHit(Ray ray) {
        int light = path.at.light;
        double weight = causticPass == null ? 1 : causticPass.weightOfHit(state, ray, light);
        if (weight > 0) {
            weight *= images.weightOfHit(state, ray, light) * nextEvent.weightOfHit(state, ray, light);
        }
        if (weight > 0 && mirrorCaustics != null) {
            weight *= mirrorCaustics.weightOfHit(state, ray, light);
        }
        return weight;
    }
}

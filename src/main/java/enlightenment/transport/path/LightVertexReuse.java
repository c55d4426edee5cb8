package enlightenment.transport.path;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.bidirectional.BidirectionalContinuation;
import enlightenment.transport.bidirectional.LightDivision;
import enlightenment.transport.bidirectional.LightVertices;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.CausticPass;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * Path reuse with light subpaths: paths are continued from their second vertex on by bidirectional path tracing, and the vertices of light
 * subpaths give light to the first vertices of all paths of a group, as second vertices do ({@link PathConnections};
 * docs/notes/light-vertices.md). One per thread.
 */
final class LightVertexReuse {
    private final PhysicalScene physical;
    private final PathFollower path;
    private final BidirectionalContinuation continuation;
    private final Ray ray = new Ray();
    private final double[] color = new double[3];
    private final double[] rgb = new double[3];

    private LightVertexReuse(CompiledScene scene, RayCounters counters, PathFollower path) {
        physical = scene.physical;
        this.path = path;
        CausticPass caustics = physical.hasCausticPass() ? physical.caustics : null;
        continuation = new BidirectionalContinuation(scene, counters, path, caustics);
    }

    /** Makes the path reuse of one thread; null where the scene does not allow it. */
    static LightVertexReuse of(CompiledScene scene, RayCounters counters, PathFollower path) {
        return BidirectionalContinuation.isPossible(scene.physical)
                ? new LightVertexReuse(scene, counters, path)
                : null;
    }

    void stopWhen(BooleanSupplier condition) {
        continuation.stopWhen(condition);
    }

    /** Begins a path: traces its light subpath. */
    void begin(Sampler sampler, PathCut cut) {
        if (cut.light == null) {
            cut.light = new LightVertices(physical);
        }
        continuation.emit(sampler, cut.light);
        cut.sampler = sampler;
    }

    /** Connects the path's first vertex to vertices of its light subpath that are not shared. */
    void connectFirst(Ray arrived, PathCut cut, PathState state, PathValue value) {
        if (cut.light.hasOwn(cut.takes)) {
            continuation.connectFirst(arrived, state.address, cut.light, cut.takes, rgb);
            value.add(rgb[0], rgb[1], rgb[2]);
        }
    }

    /**
     * Continues the path to its end if it has come to an opaque surface after its first vertex, unless it is to be cut there.
     *
     * @return whether it has ended
     */
    boolean follow(Ray arrived, PathCut cut, PathState state, PathValue value, Sampler sampler) {
        if (!state.isNarrowSampledByCausticPass() || path.at.bsdf.isDelta()) {
            return false;
        }
        boolean isSecond = !cut.gives && path.surfaces == 1 && state.events == 1 && state.hasDirect;
        boolean isShared = cut.takes && BidirectionalContinuation.isShareable(path);
        if (isSecond && isShared && BidirectionalContinuation.isShared(path)) {
            return false;
        }
        double density = isSecond && !isShared ? density(arrived, state) : 0;
        continuation.follow(arrived, sampler, state.address, density, cut.light, rgb);
        value.add(rgb[0], rgb[1], rgb[2]);
        return true;
    }

    /** The density per area with which the path's last BSDF sample has found the current surface. */
    private double density(Ray arrived, PathState state) {
        double distance = path.distance(arrived);
        Scattering s = path.arrive(arrived, color);
        return state.pdf * Math.abs(s.geometricCosineOut()) / (distance * distance);
    }

    /**
     * Finds the light that a second vertex gives.
     *
     * @param density the expected number of second vertices per area there, over that of light subpaths
     * @param by divides it, if the vertex is rough; of a matte one it becomes {@link PathCut#given}
     */
    void finish(PathCut cut, double density, LightDivision by) {
        ray.set(cut.arrived);
        path.resume(ray);
        if (path.next(ray) != PathFollower.Event.SURFACE) {
            return;
        }
        if (cut.secondLobes == null) {
            continuation.follow(ray, cut.sampler, cut.address, density, cut.light, cut.given);
        } else {
            continuation.follow(ray, cut.sampler, cut.address, density, cut.light, by);
        }
    }
}

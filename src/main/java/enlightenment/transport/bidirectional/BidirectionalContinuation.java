package enlightenment.transport.bidirectional;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.Departure;
import enlightenment.transport.ray.PathFollower;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.CausticPass;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * Continues paths from the eye, from their second vertex on, by bidirectional path tracing. First vertices may be connected to vertices of
 * light subpaths elsewhere: as the eye is in {@link BidirectionalTracer}, but with the density of the second vertex in place of the
 * camera's. Paths that the caustic pass samples are left to it. One per thread.
 */
public final class BidirectionalContinuation {
    private final EyeSubpath eye;
    private final BidirectionalGathering gathering;
    private final CausticPass caustics;
    private final MeanLobe lobe = new MeanLobe();
    private final double[] gathered = new double[3];

    /**
     * @param path follows the paths that are continued
     * @param caustics the caustic pass that paths of some light are left to; null if the scene has none
     */
    public BidirectionalContinuation(
            CompiledScene scene, RayCounters counters, PathFollower path, CausticPass caustics) {
        eye = new EyeSubpath(scene, counters, path, caustics);
        gathering = new BidirectionalGathering(scene, counters, eye, null);
        this.caustics = caustics;
    }

    /**
     * Whether the paths of a scene can be continued so: not where media scatter light, glass disperses it, surfaces are fluorescent, or masks
     * have holes.
     */
    public static boolean isPossible(PhysicalScene physical) {
        return !physical.hasScattering
                && !physical.hasDispersion
                && physical.lightOfBands == null
                && !physical.hasMasks;
    }

    /** Sets the condition on which light subpaths are given up. */
    public void stopWhen(BooleanSupplier condition) {
        gathering.light.path.poll.stopWhen(condition);
    }

    /**
     * Whether light can be shared among paths at the current surface: where it is {@linkplain Departure#isOpen open}, has no delta lobe, and
     * has no interpolated normals.
     */
    public static boolean isShareable(PathFollower path) {
        return Departure.isOpen(path) && !path.at.bsdf.hasDelta() && !path.at.isSmooth();
    }

    /** Whether the light of the current surface, where it {@linkplain #isShareable can be}, is shared among paths: not at narrow lobes. */
    public static boolean isShared(PathFollower path) {
        return !path.at.bsdf.isNarrow();
    }

    /** Traces a light subpath. */
    public void emit(Sampler sampler, LightVertices into) {
        LightSubpath light = gathering.light;
        light.vertices = into.vertices;
        boolean goes = light.begin(sampler);
        while (goes) {
            int before = into.size();
            LightSubpath.Event event = light.next(sampler);
            boolean isLeft = isNarrowCaustic(event);
            if (into.size() > before) {
                boolean isSurface = event == LightSubpath.Event.SURFACE;
                boolean isOpen = isSurface && isShareable(light.path);
                into.note(light, isSurface, isOpen, isOpen && isShared(light.path));
                if (isLeft) {
                    into.vertices.bar();
                }
            }
            goes = !isLeft && light.goesOn(event, sampler);
            // Of light that a specular event has sent on first, the caustic pass samples all.
            goes &= caustics == null || light.state.events != 1 || light.state.hasDirect;
        }
    }

    /** Whether the light subpath's first event is at a narrow lobe that the caustic pass takes. */
    private boolean isNarrowCaustic(LightSubpath.Event event) {
        LightSubpath light = gathering.light;
        return caustics != null
                && light.state.events == 0
                && (event == LightSubpath.Event.SURFACE || event == LightSubpath.Event.INTERFACE)
                && caustics.takesNarrow(light.bsdf)
                && caustics.takesNarrow(light.source.light);
    }

    /**
     * Connects the surface that the path is at, its first vertex, to vertices of its own light subpath: to those that are not shared among
     * paths, if it shares light, else to all.
     *
     * @param arrived the ray by which the path came
     * @param address of the path's next random numbers
     * @param shares whether the path's first vertex receives light from the vertices of other paths
     * @param out receives the radiance towards the eye, by band
     */
    public void connectFirst(Ray arrived, int address, LightVertices own, boolean shares, double[] out) {
        gathering.light.vertices = own.vertices;
        eye.beginAt(arrived, address, 0);
        // Paths leave their first vertex without roulette.
        eye.survival = 1;
        for (int k = 0; k < own.size(); k++) {
            if (own.isOwn(k, shares)) {
                gathering.connectFirst(k);
            }
        }
        eye.value.get(out);
    }

    /**
     * Gathers all light but emission that leaves the surface that the path is at towards its last vertex, and follows it to its end.
     *
     * @param arrived the ray by which the path came
     * @param address of the path's next random numbers
     * @param density the expected number of such vertices per area, by all paths that could have found it, over the number of light
     *     subpaths that are connected to their first vertices; 0 if none is
     * @param out receives the radiance, by band
     */
    public void follow(Ray arrived, Sampler sampler, int address, double density, LightVertices own, double[] out) {
        gathering.light.vertices = own.vertices;
        eye.beginAt(arrived, address, density);
        followToEnd(sampler, out);
    }

    private void followToEnd(Sampler sampler, double[] out) {
        boolean goes = gathering.scatter(sampler);
        while (goes) {
            goes = gathering.step(sampler);
        }
        eye.value.get(out);
    }

    /**
     * Gathers light as the other {@code follow}, at a rough vertex, and divides the radiance from each direction.
     *
     * @param by divides it
     */
    public void follow(Ray arrived, Sampler sampler, int address, double density, LightVertices own, LightDivision by) {
        gathering.light.vertices = own.vertices;
        gathering.division = by;
        eye.beginAt(arrived, address, density);
        lobe.set(eye.bsdf, by);
        eye.bsdf = lobe;
        followToEnd(sampler, gathered);
        gathering.division = null;
        // All that the path has met since it left the vertex came from the direction that it left by.
        if (gathered[0] > 0 || gathered[1] > 0 || gathered[2] > 0) {
            by.divide(gathered[0], gathered[1], gathered[2]);
        }
    }
}

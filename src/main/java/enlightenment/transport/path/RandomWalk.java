package enlightenment.transport.path;

import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.direct.FlightLight;
import enlightenment.transport.direct.NextEventEstimation;
import enlightenment.transport.media.FreeFlight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.GatheredLight;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathPart;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.transport.state.PathVertex;
import enlightenment.transport.state.RussianRoulette;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.material.HomogeneousMedium;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;

/**
 * A path from the eye in scattering media: samples free flights, scatters the path, and plays Russian roulette.
 *
 * <p>One per thread, and only for scenes with such media.
 */
final class RandomWalk {
    private final PhysicalScene physical;
    private final PathFollower path;
    private final PathValue value;
    private final FlightLight along;
    private final double[] pair = new double[2];

    /** The number of flights so far: the address of the next one's random numbers. */
    private int flights;

    /** The number of scattering events in media since the path left the last surface, or the eye. */
    private int scatterings;

    /** The current medium. */
    private HomogeneousMedium medium;

    /** Index of refraction of the current medium. */
    private double index;

    private final FreeFlight flight = new FreeFlight();
    private final RussianRoulette end = new RussianRoulette();

    /** The scattering in the medium: direction of the path and, once sampled, the next one. */
    final Scattering event = new Scattering();

    private final double[] white = {1, 1, 1};

    /** The part of the light that is estimated. */
    private final PathPart part;

    private RandomWalk(CompiledScene scene, RayCounters counters, PathFollower path, PathValue value, PathPart part) {
        physical = scene.physical;
        this.path = path;
        this.value = value;
        this.part = part;
        along = new FlightLight(scene, counters, path);
    }

    /** Makes the walk of one thread; null if no medium of the scene scatters light. */
    static RandomWalk of(CompiledScene scene, RayCounters counters, PathFollower path, PathValue value, PathPart part) {
        return scene.physical.hasScattering ? new RandomWalk(scene, counters, path, value, part) : null;
    }

    /**
     * Traces the ray to its next event, or to the point where its medium scatters it.
     *
     * @param in the material of that medium, or null in empty space
     * @return the event of {@link PathFollower#next}; null if the medium scatters the path first, which is then at that point
     */
    PathFollower.Event next(Ray ray, SurfaceMaterial in, PathState state, Sampler sampler) {
        if (path.surfaces == 0) {
            flights = 0;
            scatterings = 0;
            end.begin();
            flight.begin();
        }
        medium = in == null ? null : in.medium;
        if (medium == null) {
            PathFollower.Event found = path.next(ray);
            if (found == PathFollower.Event.SURFACE) {
                arriveAtSurface();
            }
            if (found == PathFollower.Event.NOTHING && in != null && in == physical.around) {
                value.absorb(in, Double.MAX_VALUE);
            }
            return found;
        }
        value.leaveToChance(path.key);
        index = in.indexOfRefraction;
        end.depart(value.throughput.sum());
        sampler.pair(flights++, Sampler.Purpose.FLIGHT, pair);
        flight.draw(medium, value.throughput.red, value.throughput.green, value.throughput.blue, pair[0], pair[1]);
        boolean looks = gathersOn(state) && along.isWanted(ray, medium, scatterings);
        PathFollower.Event found = looks ? path.next(ray) : path.next(ray, flight.length);
        double way = found == PathFollower.Event.NOTHING ? Double.POSITIVE_INFINITY : path.distance(ray);
        if (looks) {
            gather(ray, way, state, sampler);
        }
        if (flight.length < way && !flight.isEndless()) {
            flight.scatter();
            path.stopAt(ray, flight.length, event);
            found = null;
            scatterings++;
        } else {
            flight.pass(way);
        }
        value.filter(flight.weightR, flight.weightG, flight.weightB);
        if (found == PathFollower.Event.SURFACE) {
            arriveAtSurface();
        }
        return found;
    }

    private void arriveAtSurface() {
        flight.begin();
        scatterings = 0;
    }

    /** Whether there is next-event estimation where the medium scatters the path. */
    private boolean gathers() {
        return index == 1 || physical.lightsLieInGlass;
    }

    /** Whether single scattering along the flight is estimated by equiangular sampling. */
    private boolean gathersOn(PathState state) {
        return gathers()
                && path.mayScatter()
                && part != PathPart.ALBEDO
                && !(part == PathPart.DIRECT && state.hasScattered());
    }

    private void gather(Ray ray, double way, PathState state, Sampler sampler) {
        if (along.gather(ray, way, medium, flight, !state.hasScattered(), sampler, flights - 1)) {
            GatheredLight light = along.gathered;
            if (state.hasScattered()) {
                value.addIndirect(light.red, light.green, light.blue, light.ultraviolet);
            } else {
                value.add(light);
            }
        }
    }

    /**
     * Adds direct light where the medium scatters the path, and samples the next direction.
     *
     * @param vertex is overwritten
     * @return whether the path goes on
     */
    boolean scatter(Ray ray, NextEventEstimation direct, PathVertex vertex, PathState state, Sampler sampler) {
        if (part == PathPart.ALBEDO) {
            // The flight has multiplied the throughput by the albedo.
            return value.endsWith(white);
        }
        PathEvent kind = index == 1 ? PathEvent.MEDIUM : PathEvent.REFRACTIVE_MEDIUM;
        boolean gathers = gathers();
        if (gathers) {
            along.end();
            vertex.set(medium.phase, event, white, kind, false);
            direct.direct(vertex, along, state, sampler, value);
        }
        sampler.pair(state.address++, Sampler.Purpose.DIRECTION, pair);
        medium.phase.sample(event, pair[0], pair[1], 0);
        ray.set(path.at.hit.px, path.at.hit.py, path.at.hit.pz, event.ix, event.iy, event.iz, 0);
        if (gathers) {
            state.extend(kind, event, false);
        } else {
            state.extendWithoutDirect();
        }
        return survives(sampler, state);
    }

    /** Plays Russian roulette where the medium scattered the path, by its throughput now over that before the flight. */
    private boolean survives(Sampler sampler, PathState state) {
        double survival = end.survival(
                value.throughput.sum(), path.at.hit.px, path.at.hit.py, path.at.hit.pz, value.isSafe(state));
        return survival == 1 || value.survives(survival, sampler, state);
    }

    /** Multiplies by the weight of an event at an interface of media, and plays Russian roulette. */
    boolean survives(double[] weight, Sampler sampler, PathState state) {
        value.filter(weight[0], weight[1], weight[2]);
        double survival = end.survivalAtInterface(weight[0], weight[1], weight[2]);
        return value.isSafe(state) || value.survives(survival, sampler, state);
    }
}

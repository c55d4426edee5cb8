package enlightenment.transport.direct;

import enlightenment.bsdf.Scattering;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.SampledLight;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.media.FreeFlight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.GatheredLight;
import enlightenment.transport.state.PowerHeuristic;
import enlightenment.world.CompiledScene;
import enlightenment.world.PhysicalScene;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.material.HomogeneousMedium;
import enlightenment.world.parts.RayCounters;

/**
 * Light of lamps that a medium scatters once, at a point of each flight that is chosen equiangularly for a lamp, anywhere between where the
 * flight begins and the surface that it may come to. Where free flights end the same light is found by {@link NextEventEstimation}, and by paths that
 * run into lamps; what the three find is weighted by the power heuristic. Without this a point light in fog has an infinite variance: its
 * light grows as the inverse square of the distance, and the density of free flights does not. One per thread.
 */
public final class FlightLight {
    private final PhysicalScene physical;
    private final PathFollower path;
    private final RayCounters counters;
    private final LightView view = new LightView();
    private final ShadowRays shadow;
    private final SampledLight choice = new SampledLight();
    private final Scattering s = new Scattering();
    private final double[] pair = new double[2];

    /** The point of the flight that was chosen. */
    private double x;

    private double y;
    private double z;

    /** The lamps near to the flight that the path is on. */
    private FlightLamps near;

    /** Those of the flight that ended where light was gathered last. */
    private FlightLamps ended;

    /** What the medium scatters into the path. */
    public final GatheredLight gathered;

    public FlightLight(CompiledScene scene, RayCounters counters, PathFollower path) {
        physical = scene.physical;
        this.path = path;
        this.counters = counters;
        shadow = new ShadowRays(scene, counters, path, view.cone);
        gathered = new GatheredLight(physical.hasUltraviolet);
        near = new FlightLamps(physical);
        ended = new FlightLamps(physical);
    }

    /**
     * Whether light is to be looked for along a flight, which has to be followed to the surface that it may come to then.
     *
     * @param scatterings how often media have scattered the path since it left the last surface, or the eye
     */
    public boolean isWanted(Ray ray, HomogeneousMedium medium, int scatterings) {
        return near.begin(ray, medium, scatterings);
    }

    /**
     * Looks for light along a flight.
     *
     * @param way the length up to what the ray meets; may be infinite
     * @param flight that was drawn
     * @param isFirst whether the path came to the flight from the eye by delta events only
     * @param number of the flight: the address of its random numbers
     * @return whether any was gathered
     */
    public boolean gather(
            Ray ray,
            double way,
            HomogeneousMedium medium,
            FreeFlight flight,
            boolean isFirst,
            Sampler sampler,
            int number) {
        if (!near.end(way)) {
            return false;
        }
        near.scatteredAt(flight.length, flight.density(flight.length));
        sampler.pair(number, Sampler.Purpose.FLIGHT_LAMP, pair);
        if (!near.choose(pair[0], pair[1])) {
            return false;
        }
        PhysicalLight l = physical.lights[near.lamp];
        place(ray, near.distance);
        double density = look(l, sampler, number);
        if (!(density > 0)) {
            return false;
        }
        medium.phase.evaluate(s);
        double other = flight.density(near.distance) * atEnd(l, density, isFirst);
        double f = s.valueR * PowerHeuristic.weight(other, near.density) / (near.density * density);
        if (!(f > 0) || !isVisible(l)) {
            return false;
        }
        flight.scatterAt(near.distance);
        gathered.clear();
        shadow.add(l, f * flight.weightR, f * flight.weightG, f * flight.weightB, gathered);
        return true;
    }

    /** The density with which the others find the same if a flight ends at the point, over that of the light's sample. */
    private double atEnd(PhysicalLight l, double density, boolean isFirst) {
        double gathered = NextEventEstimation.takesAll(physical.lights.length, isFirst)
                ? 1
                : physical.picker.probability(near.lamp, x, y, z, 0, 0, 0, choice);
        return PowerHeuristic.both(gathered, l.isPoint ? 0 : s.pdf / density);
    }

    /** Goes to a point of the ray. */
    private void place(Ray ray, double distance) {
        double scale = 1 / Math.sqrt(ray.dd);
        s.ox = -ray.dx * scale;
        s.oy = -ray.dy * scale;
        s.oz = -ray.dz * scale;
        x = Math.fma(-distance, s.ox, Math.fma(ray.tMin, ray.dx, ray.ox));
        y = Math.fma(-distance, s.oy, Math.fma(ray.tMin, ray.dy, ray.oy));
        z = Math.fma(-distance, s.oz, Math.fma(ray.tMin, ray.dz, ray.oz));
        shadow.beginOnTheWay(x, y, z);
    }

    /** Samples a direction to a lamp; returns its density, of a point light the squared distance, and 0 if there is none. */
    private double look(PhysicalLight l, Sampler sampler, int number) {
        counters.lightSamples++;
        if (!l.isPoint) {
            view.draw(Sampler.Purpose.FLIGHT_LIGHT, sampler, number);
        }
        double density = view.look(l, x, y, z);
        LightSample to = view.sample;
        s.ix = to.dx;
        s.iy = to.dy;
        s.iz = to.dz;
        return density;
    }

    private boolean isVisible(PhysicalLight l) {
        shadow.isFiltered = false;
        return shadow.isVisible(l, view.sample);
    }

    /** The flight has ended, and light is gathered there. */
    public void end() {
        FlightLamps before = ended;
        ended = near;
        near = before;
    }

    /**
     * The density with which the point where light was gathered last would have been chosen for a lamp along the flight, over that of free
     * flights.
     */
    double ratio(int lamp) {
        return ended.ratio(lamp);
    }
}

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
 * Single scattering of lamps along a flight in a medium, by equiangular sampling between the start of the flight and the surface that the
 * ray hits. The same light is sampled at the ends of free flights by {@link NextEventEstimation}, and by paths that hit lamps; the three
 * are combined by the power heuristic. Without this strategy a point light in fog has infinite variance: its irradiance grows as the
 * inverse square of the distance, and the density of free flights does not. One per thread.
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

    /** The sampled point of the flight, in the frame. */
    private double x;

    private double y;
    private double z;

    /** The lamps near to the current flight. */
    private FlightLamps near;

    /** The lamps near to the flight that ended at the current vertex. */
    private FlightLamps ended;

    /** The light that the medium scatters into the path, weighted. */
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
     * Whether lamps may be near to a flight; if so, the flight must be traced to the surface that the ray hits, for {@link #gather}.
     *
     * @param scatterings the number of scattering events in media since the path left the last surface, or the eye
     */
    public boolean isWanted(Ray ray, HomogeneousMedium medium, int scatterings) {
        return near.begin(ray, medium, scatterings);
    }

    /**
     * Samples a lamp and a point of the flight, and adds the weighted single scattering there to {@link #gathered}.
     *
     * @param way the length up to the surface that the ray hits, in the frame; may be infinite
     * @param flight the free flight that was sampled
     * @param isFirst whether the path came to the flight from the eye by delta events only
     * @param number of the flight: the address of its random numbers
     * @return whether any light was added
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

    /**
     * The density of the two other strategies, by the power heuristic as one, for a free flight that ends at the point; relative to the
     * density of the light's sample.
     */
    private double atEnd(PhysicalLight l, double density, boolean isFirst) {
        double gathered = NextEventEstimation.takesAll(physical.lights.length, isFirst)
                ? 1
                : physical.picker.probability(near.lamp, x, y, z, 0, 0, 0, choice);
        return PowerHeuristic.both(gathered, l.isPoint ? 0 : s.pdf / density);
    }

    /** Sets the position to a point of the ray, in the frame. */
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

    /**
     * Samples a direction to a lamp; returns its density per solid angle, of a point light the squared distance, and 0 if there is none.
     */
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

    /** Declares that the flight ended at the current vertex, where {@link NextEventEstimation} samples light next. */
    public void end() {
        FlightLamps before = ended;
        ended = near;
        near = before;
    }

    /** The density with which equiangular sampling of this lamp would have chosen the current vertex, over that of free flights. */
    double ratio(int lamp) {
        return ended.ratio(lamp);
    }
}

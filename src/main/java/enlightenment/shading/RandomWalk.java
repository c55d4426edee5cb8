package enlightenment.shading;

import enlightenment.bsdf.Scattering;
import enlightenment.compiled.HomogeneousMedium;
import enlightenment.compiled.PhysicalScene;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * A path from the eye in media that scatter light: how far it flies freely, and when it ends.
 *
 * <p>Where a medium's extinction differs between bands a flight is drawn for one of them, chosen by the path's throughput, and weighted
 * against all by the balance heuristic (A. Wilkie et al., "Hero wavelength spectral sampling", 2014; J. Novák et al., "Monte Carlo methods
 * for volumetric light transport simulation", 2018): no weight exceeds the inverse of {@link #LEAST_SHARE}. Where it does not, every
 * flight has the weight 1, and every scattering that of the medium's albedo.
 *
 * <p>One per thread, and only for scenes with such media.
 */
final class RandomWalk {
    /** The least probability of a band. */
    private static final double LEAST_SHARE = 0.1;

    /**
     * From this event on the share of paths that are still followed falls as the inverse root of the number of events. A path in a medium
     * that absorbs nothing ends only outside of it, and leaves a thick one after n events with a probability that falls as n^(−3/2): so both
     * the events of a path and its squared weight have a mean that grows as the logarithm of the medium's thickness.
     */
    private static final int LONG = 64;

    /** From this event on it falls as a geometric series: a path that can never leave has an end. */
    private static final int ENDLESS = 1 << 16;

    /** All of a scene is nearer to the origin of its frame. */
    private static final double NEAR = 4;

    /** In a medium without end nothing comes back from here. */
    private static final double FAR = 0x1p100;

    private final PhysicalScene physical;
    private final PathFollower path;
    private final PathValue value;
    private final double[] pair = new double[2];

    /** How many flights the path has begun: the address of the next one's numbers. */
    private int flights;

    /** The medium that the path is in. */
    private HomogeneousMedium medium;

    /** Its index of refraction. */
    private double index;

    /** The probabilities of the bands, unless the medium is grey. */
    private double shareR;

    private double shareG;
    private double shareB;

    /** How far the path flies unless something is in its way. */
    private double length;

    /** How many events of media and their borders the path has had. */
    private int events;

    /** Whether the last event was one of a medium at which roulette was played. */
    private boolean isLevel;

    /** The throughput, summed over bands, that roulette keeps up. */
    private double level;

    /** How far from the origin the path has been. */
    private double farthest;

    /** The point at which the path is scattered. */
    final Scattering event = new Scattering();

    private final double[] white = {1, 1, 1};

    /** Whether a path is worth the share of light that is scattered where it is scattered first. */
    private final boolean isAlbedo;

    private RandomWalk(PhysicalScene physical, PathFollower path, PathValue value, boolean isAlbedo) {
        this.isAlbedo = isAlbedo;
        this.physical = physical;
        this.path = path;
        this.value = value;
    }

    /** What follows a thread's paths through the media of a scene; null if it has none that scatter light. */
    static RandomWalk of(PhysicalScene physical, PathFollower path, PathValue value, boolean isAlbedo) {
        return physical.hasScattering ? new RandomWalk(physical, path, value, isAlbedo) : null;
    }

    private void begin() {
        flights = 0;
        events = 0;
        isLevel = false;
        farthest = NEAR;
    }

    /**
     * Follows the ray to what it meets next, or to where the medium that it is in scatters it.
     *
     * @param in the material of that medium, or null in empty space
     * @return what {@link PathFollower#next} says; null if the medium scatters it first: then the path is there
     */
    PathFollower.Event next(Ray ray, SurfaceMaterial in, Sampler sampler) {
        if (path.surfaces == 0) {
            begin();
        }
        medium = in == null ? null : in.medium;
        if (medium == null) {
            return path.next(ray);
        }
        value.leaveToChance(path.key);
        index = in.indexOfRefraction;
        if (!isLevel) {
            level = value.throughput();
        }
        isLevel = false;
        draw(sampler);
        PathFollower.Event found = path.next(ray, length);
        if (found != PathFollower.Event.NOTHING) {
            pass(path.distance(ray));
            return found;
        }
        if (length > FAR) {
            pass(Double.POSITIVE_INFINITY);
            return found;
        }
        scatter();
        path.stopAt(ray, length, event);
        return null;
    }

    /** Draws the length of a flight. */
    private void draw(Sampler sampler) {
        sampler.pair(flights++, Sampler.Purpose.FLIGHT, pair);
        double extinction = medium.extinctionR;
        if (!medium.isGrey) {
            double sum = value.throughput();
            double scale = (1 - 3 * LEAST_SHARE) / sum;
            shareR = Math.fma(value.throughputR, scale, LEAST_SHARE);
            shareG = Math.fma(value.throughputG, scale, LEAST_SHARE);
            shareB = Math.fma(value.throughputB, scale, LEAST_SHARE);
            extinction = pair[1] < shareR
                    ? medium.extinctionR
                    : pair[1] < shareR + shareG ? medium.extinctionG : medium.extinctionB;
        }
        length = extinction > 0 ? -StrictMath.log1p(-pair[0]) / extinction : Double.POSITIVE_INFINITY;
    }

    /** Multiplies the throughput by what a flight without scattering is worth: transmittances over their mean. */
    private void pass(double flown) {
        if (!medium.isGrey) {
            weigh(flown, 1, 1, 1, 1, 1, 1);
        } else if (flown == Double.POSITIVE_INFINITY && medium.extinctionR > 0) {
            value.filter(0, 0, 0);
        }
    }

    /** The same of one that ends by scattering. */
    private void scatter() {
        HomogeneousMedium m = medium;
        if (m.isGrey) {
            value.filter(m.scatteringR / m.extinctionR, m.scatteringG / m.extinctionG, m.scatteringB / m.extinctionB);
        } else {
            weigh(length, m.scatteringR, m.scatteringG, m.scatteringB, m.extinctionR, m.extinctionG, m.extinctionB);
        }
    }

    /** Multiplies it by numbers by band times transmittances, over the mean of other numbers times transmittances. */
    private void weigh(double flown, double r, double g, double b, double overR, double overG, double overB) {
        double red = transmittance(medium.extinctionR, flown);
        double green = transmittance(medium.extinctionG, flown);
        double blue = transmittance(medium.extinctionB, flown);
        double density = shareR * red * overR + shareG * green * overG + shareB * blue * overB;
        double scale = density > 0 ? 1 / density : 0;
        value.filter(r * red * scale, g * green * scale, b * blue * scale);
    }

    private static double transmittance(double extinction, double flown) {
        return extinction > 0 ? StrictMath.exp(-extinction * flown) : 1;
    }

    /**
     * Gathers light where the medium scatters the path, and lets it go on from there.
     *
     * @param address of its random numbers
     * @return whether the path goes on
     */
    boolean scatter(Ray ray, PathLight light, PathHistory history, Sampler sampler, int address) {
        if (isAlbedo) {
            // The flight has multiplied the throughput by it.
            return value.endsWith(white);
        }
        boolean gathers = index == 1 || physical.lightsLieInGlass;
        if (gathers) {
            light.gather(medium.phase, event, sampler, address, !history.scattered);
            value.add(light.red, light.green, light.blue, light.ultraviolet);
        }
        sampler.pair(address, Sampler.Purpose.DIRECTION, pair);
        medium.phase.sample(event, pair[0], pair[1], 0);
        light.left(event.pdf);
        ray.set(path.hit.px, path.hit.py, path.hit.pz, event.ix, event.iy, event.iz, 0);
        history.leaveInMedium(gathers);
        return survives(sampler, history.events);
    }

    /** Plays roulette where the medium scattered the path: by its throughput now, against what that was before. */
    private boolean survives(Sampler sampler, int event) {
        events++;
        double distance = Math.sqrt(path.hit.px * path.hit.px + path.hit.py * path.hit.py + path.hit.pz * path.hit.pz);
        isLevel = distance > NEAR || !value.isSafe(event + 1);
        if (!isLevel) {
            return true;
        }
        level /= Math.min(farthest / distance, 1) * thinning();
        farthest = Math.max(farthest, distance);
        return value.survives(Math.min(value.throughput() / level, 1), sampler, event);
    }

    /** The share of paths that go on from here because they have had so many events. */
    private double thinning() {
        return events <= LONG ? 1 : Math.sqrt(1 - 1.0 / Math.min(events, ENDLESS));
    }

    /**
     * Multiplies by the weight of an event at a border of media, and plays roulette. Inside a white medium nothing but its border turns a path,
     * so that the usual end of every hundredth path would make noise of the others.
     */
    boolean survives(double[] weight, Sampler sampler, int event) {
        value.filter(weight[0], weight[1], weight[2]);
        events++;
        double most = Math.max(weight[0], Math.max(weight[1], weight[2]));
        return value.isSafe(event + 1) || value.survives(Math.min(most, 1) * thinning(), sampler, event);
    }
}

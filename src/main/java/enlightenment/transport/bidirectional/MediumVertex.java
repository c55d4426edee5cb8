package enlightenment.transport.bidirectional;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.media.FreeFlight;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.Throughput;
import enlightenment.world.material.HomogeneousMedium;
import enlightenment.world.material.SurfaceMaterial;

/**
 * A flight of a {@link Subpath} through a medium that scatters light, and the vertex at its end. One per path, and only for scenes with
 * such media.
 */
final class MediumVertex {
    /**
     * Upper bound of the survival probability. It must not depend on depth, so that the reverse density is known; a path in a medium that
     * absorbs nothing ends by this bound alone.
     */
    private static final double LARGEST_SURVIVAL = 1 - 0x1p-8;

    /** The scattering at the vertex, which has no normal. */
    final Scattering event = new Scattering();

    /** The throughput weights of the flight, by band. */
    final FreeFlight flight = new FreeFlight();

    private final PathFollower path;
    private final Sampler.Purpose flying;
    private final double[] pair = new double[2];
    private SurfaceMaterial material;
    private int flights;

    /**
     * @param flying the purpose of the random numbers of flights
     */
    MediumVertex(PathFollower path, Sampler.Purpose flying) {
        this.path = path;
        this.flying = flying;
    }

    /** Begins a path: its next flight is the first. */
    void begin() {
        flights = 0;
        flight.begin();
    }

    /** The phase function of the medium. */
    Bsdf phase() {
        return material.medium.phase;
    }

    /**
     * The factor from a density per solid angle to one of vertices, as the cosine is at a surface. In truth that is extinction times
     * transmittance of the flight's band; MIS weights stay valid for any number that is the same for all strategies.
     */
    double density() {
        HomogeneousMedium m = material.medium;
        return (m.extinctionR + m.extinctionG + m.extinctionB) / 3;
    }

    /** The survival probability of Russian roulette here. */
    double survival() {
        HomogeneousMedium m = material.medium;
        double most = Math.max(
                albedo(m.scatteringR, m.extinctionR),
                Math.max(albedo(m.scatteringG, m.extinctionG), albedo(m.scatteringB, m.extinctionB)));
        return Math.min(most, LARGEST_SURVIVAL);
    }

    private static double albedo(double scattering, double extinction) {
        return extinction > 0 ? scattering / extinction : 0;
    }

    /** The index of refraction of the medium. */
    double index() {
        return material.indexOfRefraction;
    }

    /**
     * Traces the ray to its next event, or to where the medium scatters the path: then the path is there, and this is null.
     *
     * @param in the medium's material
     * @param carried throughput of the subpath
     */
    PathFollower.Event fly(Ray ray, SurfaceMaterial in, Throughput carried, Sampler sampler) {
        material = in;
        sampler.pair(flights++, flying, pair);
        flight.draw(in.medium, carried.red, carried.green, carried.blue, pair[0], pair[1]);
        PathFollower.Event found = path.next(ray, flight.length);
        boolean isNothing = found == PathFollower.Event.NOTHING;
        if (isNothing && !flight.isEndless()) {
            flight.scatter();
            path.stopAt(ray, flight.length, event);
            return null;
        }
        flight.pass(isNothing ? Double.POSITIVE_INFINITY : path.distance(ray));
        return found;
    }
}

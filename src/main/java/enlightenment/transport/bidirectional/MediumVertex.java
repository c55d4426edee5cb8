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
 * A flight of a {@link Subpath} through a medium that scatters light, and the vertex at which it does. One per path, and only for scenes
 * with such media.
 */
final class MediumVertex {
    /**
     * The most that roulette lets go on: whoever comes the other way does not know how long the path has been, so that nothing but a part
     * of all events can end a path in a medium that absorbs nothing.
     */
    private static final double LARGEST_SURVIVAL = 1 - 0x1p-8;

    /** The vertex; it has no normal. */
    final Scattering event = new Scattering();

    /** By band what the flight multiplies what the path carries by. */
    final FreeFlight flight = new FreeFlight();

    private final PathFollower path;
    private final Sampler.Purpose flying;
    private final double[] pair = new double[2];
    private SurfaceMaterial material;
    private int flights;

    /** @param flying what the numbers of flights are for */
    MediumVertex(PathFollower path, Sampler.Purpose flying) {
        this.path = path;
        this.flying = flying;
    }

    /** Begins a path. */
    void begin() {
        flights = 0;
        flight.begin();
    }

    /** How the medium scatters. */
    Bsdf phase() {
        return material.medium.phase;
    }

    /**
     * What turns a density of directions into one of vertices, as the cosine does at a surface. In truth that is extinction times
     * transmittance, of the flight's band; any number will do that is the same for all ways to find the path.
     */
    double density() {
        HomogeneousMedium m = material.medium;
        return (m.extinctionR + m.extinctionG + m.extinctionB) / 3;
    }

    /** The probability with which a path goes on from here. */
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
     * Follows the ray to what it meets next, or to where the medium scatters it: then the path is there, and this is null.
     *
     * @param in the medium's material
     * @param carried what is left of the path's light
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

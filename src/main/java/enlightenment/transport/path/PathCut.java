package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.bidirectional.LightVertices;
import enlightenment.transport.ray.Departure;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.IncidentLight;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.world.surface.SurfaceInteraction;
import java.util.Arrays;

/**
 * A path that is cut at its second vertex, so that the light there is shared with all paths whose first vertices see it (P. Bekaert, M.
 * Sbert and J. Halton, "Accelerating path tracing by re-using paths", 2002).
 *
 * <p>A path is cut only if both vertices are opaque, not mirrors, and on surfaces that a ray which leaves them cannot meet again: flat, or
 * convex from outside. The radiance that leaves a matte second vertex is the same in all directions. At a rough one incident light is
 * shared together with its direction: the light sample, and the emission met in the direction of the BSDF sample.
 */
public final class PathCut {
    /** The number of events of a path at the vertex after the cut. */
    private static final int EVENTS = 2;

    /** Whether the first vertex can receive light from second vertices of other paths. */
    boolean takes;

    /** Whether the second vertex can give light to first vertices of other paths. */
    boolean gives;

    final Hit first = new Hit();
    int firstId;
    final Hit second = new Hit();
    int secondId;

    /** The colour of the first vertex if it is matte. */
    final double[] albedo = new double[3];

    /** The BSDF of the first vertex, and its scattering geometry; null if it is matte. */
    Bsdf firstLobes;

    final Scattering atFirst = new Scattering();

    /** The BSDF of the second vertex, and its scattering geometry; null if it is matte. */
    Bsdf secondLobes;

    final Scattering atSecond = new Scattering();

    /** The radiance of the path without the part that leaves the second vertex. */
    final double[] own = new double[3];

    /**
     * Of a matte second vertex, the radiance that leaves it without its own emission; of a rough one, incident radiance in the direction of
     * the BSDF sample, without {@link #lamp} and {@link #met}.
     */
    final double[] given = new double[3];

    /** The light sample at a rough second vertex. */
    final IncidentLight lamp = new IncidentLight();

    /** Whether there was a BSDF sample at the rough second vertex, and its direction. */
    boolean wentOn;

    double onX;
    double onY;
    double onZ;

    /**
     * Emission of a light that the BSDF sample met directly, and the density with which next-event estimation would have sampled it; 0 if
     * it met none.
     */
    final double[] met = new double[3];

    double metDensity;

    /** Where light subpaths are reused: whether the light that the second vertex gives has yet to be found. */
    boolean isOpenEnded;

    /** The ray by which such a path came to its second vertex, and the address of its next random numbers. */
    final Ray arrived = new Ray();

    int address;

    /** Where light subpaths are reused, the sampler of the path, and the vertices of its light subpath. */
    Sampler sampler;

    LightVertices light;

    /** Makes a path that shares nothing, to be passed to {@link PathIntegrator#shade}. */
    public PathCut() {}

    /** Makes this a path that shares nothing. */
    public void clear() {
        takes = false;
        gives = false;
        isOpenEnded = false;
    }

    /** Leaves the path open at its second vertex. */
    void endOpen(Ray ray, PathState state) {
        isOpenEnded = true;
        arrived.set(ray);
        address = state.address;
        Arrays.fill(given, 0);
    }

    /**
     * Records a matte vertex. The first receives light from other paths if its own path is sure to continue; the second cuts the path,
     * whose value is relative to it from then on. Thin slabs count as surfaces although they are no events, so shared light has passed
     * none.
     *
     * @param color of the surface
     * @param isFluorescent whether the surface re-emits light in other bands: then it receives none from other paths
     */
    void note(PathFollower path, double[] color, PathValue value, boolean isFluorescent) {
        if (path.surfaces == 0 && !isFluorescent) {
            takes = Departure.isOpen(path) && Math.max(color[0], Math.max(color[1], color[2])) >= PathValue.FAINT;
            if (takes) {
                begin(path, null);
                System.arraycopy(color, 0, albedo, 0, 3);
            }
        } else {
            noteLater(path, value);
        }
    }

    private void begin(PathFollower path, Bsdf lobes) {
        first.set(path.at.hit);
        firstId = path.at.id;
        firstLobes = lobes;
    }

    /**
     * Records a rough vertex, where paths that may be cut continue without Russian roulette.
     *
     * @param s the scattering there
     * @param mayGive whether light can be shared there
     * @return whether the path is cut here
     */
    boolean noteRough(PathFollower path, Bsdf lobes, Scattering s, PathValue value, boolean mayGive) {
        if (path.surfaces == 0) {
            takes = Departure.isOpen(path);
            if (takes) {
                begin(path, lobes);
                atFirst.arriveAs(s);
            }
            return false;
        }
        if (mayGive) {
            noteLater(path, value);
        }
        if (gives) {
            secondLobes = lobes;
            atSecond.arriveAs(s);
            wentOn = false;
            metDensity = 0;
        }
        return gives;
    }

    private void noteLater(PathFollower path, PathValue value) {
        gives = path.surfaces == 1 && takes && Departure.isOpen(path);
        if (gives) {
            second.set(path.at.hit);
            secondId = path.at.id;
            secondLobes = null;
            value.get(own);
            value.beginPart();
        }
    }

    /** Records the BSDF sample at a rough second vertex. */
    void leave(Scattering s) {
        wentOn = true;
        onX = s.ix;
        onY = s.iy;
        onZ = s.iz;
    }

    /** Whether the path has come directly from the rough vertex that it was cut at. */
    boolean isLeft(PathState state) {
        return gives && secondLobes != null && state.events == EVENTS;
    }

    /**
     * Records the light that the BSDF sample has met, if it has met one.
     *
     * @param density with which next-event estimation would have sampled it
     * @return whether it could have
     */
    boolean meets(SurfaceInteraction light, PathValue value, double density) {
        if (density > 0 && light.emits()) {
            metDensity = density;
            value.getEmission(light, met);
        }
        return density > 0;
    }

    /** Writes the radiance of the path without the part that leaves the second vertex. */
    public void own(double[] out) {
        System.arraycopy(own, 0, out, 0, 3);
    }

    /** Writes the radiance of the path by its own second vertex, without reuse; 0 if the path was not cut. */
    public void bringsAlone(double[] out) {
        LobeShares.alone(this, out);
    }

    /** Whether the second vertex can give light to first vertices of other paths. */
    public boolean gives() {
        return gives;
    }
}

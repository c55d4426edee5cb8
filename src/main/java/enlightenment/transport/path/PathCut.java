package enlightenment.transport.path;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.state.IncidentLight;
import enlightenment.transport.state.PathState;
import enlightenment.transport.state.PathValue;
import enlightenment.world.surface.SurfaceInteraction;

/**
 * A path that is cut at its second vertex, so that what comes from there can be shared: by all paths whose first vertices see it
 * (P. Bekaert, M. Sbert and J. Halton, "Accelerating path tracing by re-using paths", 2002).
 *
 * <p>It can be if both vertices are opaque, no mirrors, and surfaces that a ray which leaves them cannot meet again: flat, or convex from
 * outside. If the second is matte, the light that leaves it is the same in all directions. If it is rough, what arrives there is shared
 * with the directions that it comes from: a light that was sampled, and what was met in the direction that the path went on.
 */
public final class PathCut {
    /** How many events the path has had when it comes from the vertex that it was cut at. */
    private static final int EVENTS = 2;

    /** Whether the first vertex can take light from the second ones of other paths. */
    boolean takes;

    /** Whether the second vertex can give light to the first ones of other paths. */
    boolean gives;

    final Hit first = new Hit();
    int firstId;
    final Hit second = new Hit();
    int secondId;

    /** The colour of the first vertex if it is matte. */
    final double[] albedo = new double[3];

    /** How the first vertex scatters, and where; null if it is matte. */
    Bsdf firstLobes;

    final Scattering atFirst = new Scattering();

    /** The same of the second. */
    Bsdf secondLobes;

    final Scattering atSecond = new Scattering();

    /** What the path brings without what leaves the second vertex. */
    final double[] own = new double[3];

    /**
     * Radiance that leaves a matte second vertex, but for its own emission; or that arrives at a rough one, but for {@link #lamp} and
     * {@link #met}.
     */
    final double[] given = new double[3];

    /** The light that was sampled at a rough second vertex. */
    final IncidentLight lamp = new IncidentLight();

    /** Whether the path went on from there; and in which direction. */
    boolean wentOn;

    double onX;
    double onY;
    double onZ;

    /**
     * Radiance of a light that it met straight, and the density with which this would have been sampled at the vertex; 0 if it met none.
     */
    final double[] met = new double[3];

    double metDensity;

    /** A path that is yet to be followed. */
    public PathCut() {}

    /**
     * Whether a ray that leaves the surface there cannot meet it again, or knows the element that it does not meet; in empty space, and where it
     * coincides with no other.
     */
    private static boolean isOpen(PathFollower path) {
        Primitive p = path.at.hit.primitive;
        return path.glass.isPlain()
                && path.medium() == null
                && (p.hasElements() || p.isFlat() || p.isConvex() && path.at.hit.side == Ray.OUTSIDE);
    }

    /** Makes this a path that shares nothing. */
    public void clear() {
        takes = false;
        gives = false;
    }

    /**
     * Notes a matte vertex if it is the first: others may give to it if it is sure that its path goes on; or cuts the path if it is the
     * second: from here on it is worth what leaves this. Surfaces are counted with panes, which are no events: what is shared has come
     * straight.
     *
     * @param color of the surface there
     * @param isFluorescent whether what it makes of light is more than its colour says: then it takes none from others
     */
    void note(PathFollower path, double[] color, PathValue value, boolean isFluorescent) {
        if (path.surfaces == 0 && !isFluorescent) {
            takes = isOpen(path) && Math.max(color[0], Math.max(color[1], color[2])) >= PathValue.FAINT;
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
     * The same for a rough vertex, where paths that may be cut go on without roulette.
     *
     * @param s what is known of it
     * @param mayGive whether light can be shared there
     * @return whether the path is cut here
     */
    boolean noteRough(PathFollower path, Bsdf lobes, Scattering s, PathValue value, boolean mayGive) {
        if (path.surfaces == 0) {
            takes = isOpen(path);
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
        gives = path.surfaces == 1 && takes && isOpen(path);
        if (gives) {
            second.set(path.at.hit);
            secondId = path.at.id;
            secondLobes = null;
            value.get(own);
            value.beginPart();
        }
    }

    /** The path goes on from a rough second vertex. */
    void leave(Scattering s) {
        wentOn = true;
        onX = s.ix;
        onY = s.iy;
        onZ = s.iz;
    }

    /** Whether the path has come straight from a rough vertex that it was cut at. */
    boolean isLeft(PathState state) {
        return gives && secondLobes != null && state.events == EVENTS;
    }

    /** It meets a light then. */
    void meet(SurfaceInteraction light, PathValue value, double density) {
        metDensity = density;
        value.getEmission(light, met);
    }

    /** Writes what the path brings without what leaves the second vertex. */
    public void own(double[] out) {
        System.arraycopy(own, 0, out, 0, 3);
    }

    /** Writes what the second vertex brings the path if nothing is shared; 0 if it gives nothing. */
    public void bringsAlone(double[] out) {
        LobeShares.alone(this, out);
    }

    /** Whether the second vertex can give light to the first ones of other paths. */
    public boolean gives() {
        return gives;
    }
}

package enlightenment.shading;

import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;

/**
 * A path that is cut at its second vertex, so that what comes from there can be shared: by all paths whose first vertices see it
 * (P. Bekaert, M. Sbert and J. Halton, "Accelerating path tracing by re-using paths", 2002).
 *
 * <p>It can be if both vertices are matte surfaces that a ray which leaves them cannot meet again: flat, or convex from outside. Then the
 * light that leaves the second is the same in all directions, and whatever sees its front is lit by it.
 */
public final class PathCut {
    /** Whether the first vertex can take light from the second ones of other paths. */
    boolean takes;

    /** Whether the second vertex can give light to the first ones of other paths. */
    boolean gives;

    final Hit first = new Hit();
    int firstId;
    final Hit second = new Hit();
    int secondId;
    final double[] albedo = new double[3];

    /** What the path brings without what leaves the second vertex. */
    final double[] own = new double[3];

    /** Radiance that leaves the second vertex, but for its own emission. */
    final double[] given = new double[3];

    /** A path that is yet to be followed. */
    public PathCut() {}

    /** Whether a ray that leaves the surface there cannot meet it again; in empty space, and where it coincides with no other. */
    private static boolean isOpen(PathFollower path) {
        Primitive p = path.hit.primitive;
        return path.glass.isPlain()
                && path.medium() == null
                && (p.isFlat() || p.isConvex() && path.hit.side == Ray.OUTSIDE);
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
     */
    void note(PathFollower path, double[] color, PathValue value) {
        if (path.surfaces == 0) {
            takes = isOpen(path) && Math.max(color[0], Math.max(color[1], color[2])) >= PathValue.FAINT;
            if (takes) {
                first.set(path.hit);
                firstId = path.id;
                System.arraycopy(color, 0, albedo, 0, 3);
            }
        } else {
            noteLater(path, value);
        }
    }

    /** The same for a vertex that cannot take light from others: what it makes of light is more than its colour says. */
    void noteLater(PathFollower path, PathValue value) {
        gives = path.surfaces == 1 && takes && isOpen(path);
        if (gives) {
            second.set(path.hit);
            secondId = path.id;
            value.get(own);
            value.beginPart();
        }
    }

    /** Writes what the path brings without what leaves the second vertex. */
    public void own(double[] out) {
        System.arraycopy(own, 0, out, 0, 3);
    }

    /** What the second vertex brings the path if nothing is shared: component 0, 1 or 2; 0 if it gives nothing. */
    public double bringsAlone(int c) {
        return gives ? albedo[c] * given[c] : 0;
    }

    /** Whether the second vertex can give light to the first ones of other paths. */
    public boolean gives() {
        return gives;
    }
}

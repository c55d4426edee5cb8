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
    final Hit second = new Hit();
    final double[] albedo = new double[3];

    /** What the path brings without what leaves the second vertex. */
    final double[] own = new double[3];

    /** Radiance that leaves the second vertex, but for its own emission. */
    final double[] given = new double[3];

    /** A path that is yet to be followed. */
    public PathCut() {}

    /** Whether a ray that leaves the surface there cannot meet it again. */
    private static boolean isOpen(Hit place) {
        Primitive p = place.primitive;
        return p.isFlat() || p.isConvex() && place.side == Ray.OUTSIDE;
    }

    /** Makes this a path that shares nothing. */
    public void clear() {
        takes = false;
        gives = false;
    }

    /** Notes the first vertex of a path, or cuts it at the second: from here on it is worth what leaves this. */
    void note(PathFollower path, double[] color, PathValue value) {
        // Counted with panes, which are no events: what is shared has come straight, through empty space.
        boolean isPlain = path.glass.isPlain() && path.medium() == null;
        if (path.surfaces == 0) {
            begin(path.hit, color, isPlain);
        } else if (end(path.hit, isPlain)) {
            value.get(own);
            value.beginPart();
        }
    }

    /**
     * Notes the first vertex: others may give to it if it is sure that its path goes on.
     *
     * @param color of the surface there
     * @param isPlain whether it is in empty space and coincides with no other
     */
    private void begin(Hit at, double[] color, boolean isPlain) {
        takes = isPlain && isOpen(at) && Math.max(color[0], Math.max(color[1], color[2])) >= PathValue.FAINT;
        if (takes) {
            first.set(at);
            System.arraycopy(color, 0, albedo, 0, 3);
        }
    }

    /** Notes the second vertex; returns whether it can give light to others. */
    private boolean end(Hit at, boolean isPlain) {
        gives = takes && isPlain && isOpen(at);
        if (gives) {
            second.set(at);
        }
        return gives;
    }

    /** Writes what the path brings without what leaves the second vertex. */
    public void own(double[] out) {
        System.arraycopy(own, 0, out, 0, 3);
    }

    /** What a share of what another path's second vertex gives brings: of component 0, 1 or 2. */
    public double brings(PathCut other, double share, int c) {
        return albedo[c] * share * other.given[c];
    }

    /** Whether the second vertex can give light to the first ones of other paths. */
    public boolean gives() {
        return gives;
    }
}

package enlightenment.transport.ray;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.contact.CoincidentHits;

/** What a ray crosses at surfaces of glass that coincide: the media before and behind them, and which of them is the border of the two. */
final class GlassBorder {
    private static final int NONE = -1;

    private final CoincidentHits coincident;

    /** The solids that the ray is inside of. */
    private final MediumStack inside;

    /** Those before the last {@link #cross}. */
    private final MediumStack before;

    /** The index of the coincident surface that is the border, or -1 if the medium stays the same. */
    private int boundary = NONE;

    GlassBorder(CoincidentHits coincident, MediumStack inside, MediumStack before) {
        this.coincident = coincident;
        this.inside = inside;
        this.before = before;
    }

    /**
     * Crosses all borders that no opaque surface is before.
     *
     * @param comesToOpaque whether an opaque surface lies there, which only those borders are before that the ray leaves
     */
    void cross(boolean comesToOpaque) {
        int from = inside.current();
        before.set(inside);
        for (int k = 0; k < coincident.size(); k++) {
            if (coincident.isGlassSolid(k) && (!comesToOpaque || coincident.hit(k).side == Ray.INSIDE)) {
                inside.cross(coincident.id(k), coincident.hit(k).side);
            }
        }
        int to = inside.current();
        boundary = from == to ? NONE : coincident.border(to, from);
    }

    /** Undoes that: the ray is where it was. */
    void undo() {
        inside.set(before);
    }

    /** Whether the medium changes. */
    boolean isThere() {
        return boundary != NONE;
    }

    /** How the border scatters light, if it {@link #isThere is there}. */
    Bsdf bsdf() {
        return coincident.bsdf(boundary);
    }

    /** The hit on the border. */
    Hit hit() {
        return coincident.hit(boundary);
    }

    /** Whether coincident surface k filters the light: the border does, and so do panes that the ray passed. */
    boolean filters(int k, boolean through) {
        return k == boundary || through && coincident.isPane(k);
    }

    /**
     * Which of the surfaces is opaque, where some are so in part.
     *
     * @param number 0..1, chooses
     * @return the index of the coincident surface, or -1 if all are clear
     */
    int opaque(double number) {
        double left = number;
        for (int k = 0; k < coincident.size(); k++) {
            if (filters(k, true)) {
                double clear = coincident.material(k).transparency;
                if (left >= clear) {
                    return k;
                }
                left /= clear;
            }
        }
        return NONE;
    }

    /** What is left of a share of light that crosses them: {@link #opaque} finds all of them clear with this probability. */
    double clear(double share) {
        double left = share;
        for (int k = 0; k < coincident.size(); k++) {
            left *= filters(k, true) ? coincident.material(k).transparency : 1;
        }
        return left;
    }
}

package enlightenment.transport.ray;

import enlightenment.bsdf.Bsdf;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.world.contact.CoincidentHits;

/**
 * The change of media where several surfaces of glass coincide: the media before and behind them, and which surface is the interface of the
 * two.
 */
final class GlassInterface {
    private static final int NONE = -1;

    private final CoincidentHits coincident;

    /** The solids that the ray is inside of. */
    private final MediumStack inside;

    /** The solids that the ray was inside of before the last {@link #cross}. */
    private final MediumStack before;

    /** The index of the coincident surface that is the interface; -1 if the medium does not change. */
    private int boundary = NONE;

    GlassInterface(CoincidentHits coincident, MediumStack inside, MediumStack before) {
        this.coincident = coincident;
        this.inside = inside;
        this.before = before;
    }

    /**
     * Crosses the surfaces of all solids of glass up to the first opaque surface.
     *
     * @param comesToOpaque whether an opaque surface lies there: then only those solids are crossed that the ray leaves
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
        boundary = from == to ? NONE : coincident.boundary(to, from);
    }

    /** Undoes the last {@link #cross}. */
    void undo() {
        inside.set(before);
    }

    /** Whether the last {@link #cross} changed the medium. */
    boolean changesMedium() {
        return boundary != NONE;
    }

    /** The scattering function of the interface; requires {@link #changesMedium}. */
    Bsdf bsdf() {
        return coincident.bsdf(boundary);
    }

    /** The hit on the interface; requires {@link #changesMedium}. */
    Hit hit() {
        return coincident.hit(boundary);
    }

    /** Whether coincident surface k filters the light: the interface does, and thin slabs that the ray was transmitted by. */
    boolean filters(int k, boolean through) {
        return k == boundary || through && coincident.isPane(k);
    }

    /**
     * Samples which of the surfaces is opaque, where some are partly transparent.
     *
     * @param number uniform in [0, 1)
     * @return the index of the coincident surface; -1 if the ray passes all of them
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

    /** Multiplies a share of light by the transparency of all surfaces that it crosses: the probability that {@link #opaque} returns -1. */
    double clear(double share) {
        double left = share;
        for (int k = 0; k < coincident.size(); k++) {
            left *= filters(k, true) ? coincident.material(k).transparency : 1;
        }
        return left;
    }
}

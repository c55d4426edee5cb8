package enlightenment.primitive;

import enlightenment.numeric.Scale;

/**
 * The parameter interval in which a ray is between two parallel planes, axis by axis. Comparisons drop NaN: a ray that
 * lies in a face counts as inside (closed-box rule), whatever the sign of its zero components.
 */
final class Slabs {
    /** Bounds the rounding of the ends of two intervals, each made by one subtraction and one division. */
    private static final double INTERVAL_ERROR = 2 * Scale.gamma(3);

    private Slabs() {}

    /**
     * Whether an interval whose ends have been rounded may be non-empty: a ray through an edge, where it is one point, is not
     * lost (Ize, "Robust BVH ray traversal", JCGT 2013).
     */
    static boolean meet(double near, double far) {
        return near <= far + Math.abs(far) * INTERVAL_ERROR;
    }

    /** The t at which the ray o + t·d enters the slab lo..hi of one axis; −∞ if it is always inside, +∞ if never. */
    static double entry(double o, double d, double lo, double hi) {
        if (d > 0) {
            return (lo - o) / d;
        }
        if (d < 0) {
            return (hi - o) / d;
        }
        return o < lo || o > hi ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
    }

    /** The t at which the ray o + t·d leaves the slab lo..hi of one axis; +∞ if it is always inside, −∞ if never. */
    static double exit(double o, double d, double lo, double hi) {
        if (d > 0) {
            return (hi - o) / d;
        }
        if (d < 0) {
            return (lo - o) / d;
        }
        return o < lo || o > hi ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }

    static double clamp(double v, double lo, double hi) {
        return v < lo ? lo : v > hi ? hi : v;
    }

    /** The axis of the last entry: through a face across it the ray enters the box. */
    static int last(double x, double y, double z) {
        return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
    }

    /** The axis of the first exit: through a face across it the ray leaves the box. */
    static int first(double x, double y, double z) {
        return x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2);
    }

    static double max(double x, double y, double z) {
        double m = x >= y ? x : y;
        return m >= z ? m : z;
    }

    static double min(double x, double y, double z) {
        double m = x <= y ? x : y;
        return m <= z ? m : z;
    }

    /**
     * Texture coordinates on a face of a box, from coordinates that run 0..1 between its corners: seen from outside with
     * +y up the picture stands upright and the right way round; the faces ±y continue the face -z.
     */
    static void textureCoordinates(Hit hit, double x, double y, double z) {
        switch (hit.face) {
            case 0 -> set(hit, 1 - z, 1 - y);
            case 1 -> set(hit, z, 1 - y);
            case 2 -> set(hit, x, z);
            case 3 -> set(hit, x, 1 - z);
            case 4 -> set(hit, x, 1 - y);
            default -> set(hit, 1 - x, 1 - y);
        }
    }

    private static void set(Hit hit, double u, double v) {
        hit.u = Watertight.clamp01(u);
        hit.v = Watertight.clamp01(v);
    }
}

package enlightenment.sampling;

import enlightenment.numeric.Arcs;

/** Area-preserving maps of low distortion from the unit square to other domains. */
public final class Warp {
    private static final double QUARTER_PI = Math.PI / 4;

    private Warp() {}

    /**
     * Shirley and Chiu's concentric map to the unit disk ("A low distortion map between disk and square", 1997): uniform
     * in area.
     *
     * @param u first coordinate in the unit square
     * @param v second coordinate
     * @param out receives x, y and x² + y², which has one rounding only
     */
    public static void toDisk(double u, double v, double[] out) {
        double a = 2 * u - 1;
        double b = 2 * v - 1;
        // The larger of the two comes first. They are exchanged as bits: a branch would be guessed wrong half of the
        // time.
        long bitsA = Double.doubleToRawLongBits(a);
        long bitsB = Double.doubleToRawLongBits(b);
        long swap = Double.doubleToRawLongBits(Math.abs(a) - Math.abs(b)) >> (Long.SIZE - 1);
        long change = (bitsA ^ bitsB) & swap;
        double r = Double.longBitsToDouble(bitsA ^ change);
        double phi = r == 0 ? 0 : QUARTER_PI * (Double.longBitsToDouble(bitsB ^ change) / r);
        bitsA = Double.doubleToRawLongBits(r * Arcs.cosineNearZero(phi));
        bitsB = Double.doubleToRawLongBits(r * Arcs.sineNearZero(phi));
        change = (bitsA ^ bitsB) & swap;
        double x = Double.longBitsToDouble(bitsA ^ change);
        double y = Double.longBitsToDouble(bitsB ^ change);
        out[0] = x;
        out[1] = y;
        out[2] = r * r;
    }
}

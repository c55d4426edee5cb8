package enlightenment.sampling;

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
        bitsA = Double.doubleToRawLongBits(r * cosine(phi));
        bitsB = Double.doubleToRawLongBits(r * sine(phi));
        change = (bitsA ^ bitsB) & swap;
        double x = Double.longBitsToDouble(bitsA ^ change);
        double y = Double.longBitsToDouble(bitsB ^ change);
        out[0] = x;
        out[1] = y;
        out[2] = r * r;
    }

    /**
     * sin x for |x| ≤ π/4: Taylor's series in Horner form, whose first omitted term is below 2^-57 there. Only fused
     * operations, so the same on every machine, and faster than {@link StrictMath#sin}.
     */
    static double sine(double x) {
        double z = x * x;
        double p = Math.fma(z, 1.0 / 355687428096000.0, -1.0 / 1307674368000.0);
        p = Math.fma(z, p, 1.0 / 6227020800.0);
        p = Math.fma(z, p, -1.0 / 39916800.0);
        p = Math.fma(z, p, 1.0 / 362880.0);
        p = Math.fma(z, p, -1.0 / 5040.0);
        p = Math.fma(z, p, 1.0 / 120.0);
        p = Math.fma(z, p, -1.0 / 6.0);
        return Math.fma(z * x, p, x);
    }

    /** cos x for |x| ≤ π/4, as {@link #sine}. */
    static double cosine(double x) {
        double z = x * x;
        double p = Math.fma(z, -1.0 / 6402373705728000.0, 1.0 / 20922789888000.0);
        p = Math.fma(z, p, -1.0 / 87178291200.0);
        p = Math.fma(z, p, 1.0 / 479001600.0);
        p = Math.fma(z, p, -1.0 / 3628800.0);
        p = Math.fma(z, p, 1.0 / 40320.0);
        p = Math.fma(z, p, -1.0 / 720.0);
        p = Math.fma(z, p, 1.0 / 24.0);
        p = Math.fma(z, p, -0.5);
        return Math.fma(z, p, 1);
    }
}

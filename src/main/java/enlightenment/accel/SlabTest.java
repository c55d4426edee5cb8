package enlightenment.accel;

import enlightenment.numeric.Scale;
import enlightenment.primitive.Ray;

/**
 * The test of a ray against axis-aligned boxes. It is conservative: a box that contains an intersection is never missed,
 * because boxes are widened by a bound of the roundings of primitives, some units in the last place of the coordinates involved
 * (Ize, "Robust BVH ray traversal", JCGT 2013, pads the far end in t instead; a width in space costs the same and also covers
 * rays that graze a face).
 *
 * <p>A ray parallel to an axis has an infinite inverse there, and 0·∞ is NaN. It arises only where the origin lies
 * exactly the width outside a face, and then it rejects the box, which is right; so {@link Math#min} and
 * {@link Math#max} may be used, which have no branches to predict and measured a third faster than comparisons.
 */
final class SlabTest {
    /** Exceeds the accumulated roundings of any primitive's test, relative to the coordinates involved. */
    private static final double WIDENING = Scale.gamma(64);

    /** The origin plus the width: subtracted from lower corners, it moves them down. */
    private double lowerX;

    private double lowerY;
    private double lowerZ;

    /** The origin minus the width, for upper corners. */
    private double upperX;

    private double upperY;
    private double upperZ;
    private double invX;
    private double invY;
    private double invZ;
    private boolean backX;
    private boolean backY;
    private boolean backZ;
    private double tMin;

    /** The direction was multiplied by 2^shift, so that its inverse exists. */
    private int shift;

    /**
     * Prepares the test.
     *
     * @param reach the largest absolute coordinate of any box
     */
    void set(Ray ray, double reach) {
        ray.invert();
        shift = 0;
        tMin = ray.tMin;
        invX = ray.invX;
        invY = ray.invY;
        invZ = ray.invZ;
        if (ray.extreme) {
            rescale(ray);
        }
        double width = WIDENING * (maxAbs(ray.ox, ray.oy, ray.oz) + reach);
        lowerX = ray.ox + width;
        lowerY = ray.oy + width;
        lowerZ = ray.oz + width;
        upperX = ray.ox - width;
        upperY = ray.oy - width;
        upperZ = ray.oz - width;
        // A direction component of -0 has an inverse of -∞: it counts as backwards, which makes no difference.
        backX = invX < 0;
        backY = invY < 0;
        backZ = invZ < 0;
    }

    private void rescale(Ray ray) {
        shift = -Scale.exponent(maxAbs(ray.dx, ray.dy, ray.dz));
        invX = 1 / Scale.scalb(ray.dx, shift);
        invY = 1 / Scale.scalb(ray.dy, shift);
        invZ = 1 / Scale.scalb(ray.dz, shift);
        tMin = Math.nextDown(Scale.scalb(ray.tMin, -shift));
    }

    private static double maxAbs(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** A limit of t in the units of {@link #entry}, rounded up. */
    double limit(double t) {
        return shift == 0 ? t : Math.nextUp(Scale.scalb(t, -shift));
    }

    /**
     * Where the ray enters the box at b[at..at+5] (x, y, z of the lower, then of the upper corner), at least tMin;
     * infinity if it misses the box or enters it beyond the limit.
     */
    double entry(double[] b, int at, double limit) {
        double lx = (b[at] - lowerX) * invX;
        double ux = (b[at + 3] - upperX) * invX;
        double ly = (b[at + 1] - lowerY) * invY;
        double uy = (b[at + 4] - upperY) * invY;
        double lz = (b[at + 2] - lowerZ) * invZ;
        double uz = (b[at + 5] - upperZ) * invZ;
        double near = Math.max(Math.max(backX ? ux : lx, backY ? uy : ly), Math.max(backZ ? uz : lz, tMin));
        double far = Math.min(Math.min(backX ? lx : ux, backY ? ly : uy), Math.min(backZ ? lz : uz, limit));
        return near <= far ? near : Double.POSITIVE_INFINITY;
    }

    /**
     * The t at which the ray enters a box of floats, as {@link #entry(double[], int, double)}, whose numbers (centre and half extents)
     * begin at b[at] and lie two apart.
     */
    double entry(float[] b, int at, double limit) {
        double lx = ((double) b[at] - b[at + 6] - lowerX) * invX;
        double ux = ((double) b[at] + b[at + 6] - upperX) * invX;
        double ly = ((double) b[at + 2] - b[at + 8] - lowerY) * invY;
        double uy = ((double) b[at + 2] + b[at + 8] - upperY) * invY;
        double lz = ((double) b[at + 4] - b[at + 10] - lowerZ) * invZ;
        double uz = ((double) b[at + 4] + b[at + 10] - upperZ) * invZ;
        double near = Math.max(Math.max(backX ? ux : lx, backY ? uy : ly), Math.max(backZ ? uz : lz, tMin));
        double far = Math.min(Math.min(backX ? lx : ux, backY ? ly : uy), Math.min(backZ ? lz : uz, limit));
        return near <= far ? near : Double.POSITIVE_INFINITY;
    }
}

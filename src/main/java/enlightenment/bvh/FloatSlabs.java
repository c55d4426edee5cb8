package enlightenment.bvh;

/**
 * The test of a ray against boxes of floats, each given by its centre c and its half extents h. Along an axis the ray, with inverse
 * direction i, is in the box's slab for t from (c − o)·i − h·|i| to (c − o)·i + h·|i|: nothing depends on the sign of the direction, and
 * every number of a box is used where it stands. The test is conservative: a box that contains an intersection is never missed.
 *
 * <p><b>Roundings.</b> Let m be the largest absolute coordinate of the boxes and u = 2^-24. {@link #set} refuses origins beyond 2m, so
 * |c − o| ≤ 3m. Half extents are rounded up from the rounded centre, and widened by w = 32um ({@link #widening}). The inverse is rounded
 * (relative u), o·i once more, and each of the two fused operations; in space these are less than u(3m + 2m + 3m + 5m) &lt; w, and what is
 * left of w covers the roundings of the primitives' own tests, which are of the order of 2^-46 m. The best t so far is rounded up, tMin
 * down.
 *
 * <p><b>Range.</b> {@link #set} also refuses directions and scenes so large or small that a product could leave the normal range of floats.
 * A component of the direction below 2^-60 of a whole is taken for that: t is below 2^24 m within the scene, so the ray moves by less than
 * w along that axis, and no infinity, hence no NaN, can arise.
 *
 * <p><b>Order.</b> A time that matters is not negative, and floats that are not negative are ordered as their bits are ordered as ints; a
 * negative entry loses against tMin ≥ 0, a negative exit makes the smallest exit negative: a miss. Comparing ints takes one
 * instruction where {@link Math#max(float, float)} takes five.
 */
public final class FloatSlabs {
    /** The result of {@link #entry} for a box that the ray misses: more than the bits of infinity. */
    public static final int MISS = Integer.MAX_VALUE;

    /** Squared lengths of directions, and coordinates, for which nothing leaves the range of floats. */
    public static final double LARGEST = 0x1p40;

    private static final double SMALLEST = 0x1p-40;

    /** The widening w relative to m. */
    private static final double WIDENING = 0x1p-19;

    private static final double STEEPEST = 0x1p60;

    /** The inverse direction, its absolute value, and −o·i. */
    private float invX;

    private float sizeX;
    private float offsetX;
    private float invY;
    private float sizeY;
    private float offsetY;
    private float invZ;
    private float sizeZ;
    private float offsetZ;
    private int tMin;

    /**
     * Prepares the test.
     *
     * @param ox the ray's origin: ox, oy, oz
     * @param dx its direction: dx, dy, dz
     * @param dd the squared length of the direction
     * @param from the least t of a crossing
     * @param reach the largest absolute coordinate of any box, in the range that {@link #suits} accepts
     * @return whether this test is right for the ray
     */
    public boolean set(
            double ox, double oy, double oz, double dx, double dy, double dz, double dd, double from, double reach) {
        double o = Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz)));
        if (!(dd >= SMALLEST && dd <= LARGEST && o <= 2 * reach && from >= 0)) {
            return false;
        }
        invX = inverse(dx);
        invY = inverse(dy);
        invZ = inverse(dz);
        sizeX = Math.abs(invX);
        sizeY = Math.abs(invY);
        sizeZ = Math.abs(invZ);
        offsetX = (float) (-ox * invX);
        offsetY = (float) (-oy * invY);
        offsetZ = (float) (-oz * invZ);
        tMin = Float.floatToRawIntBits(Math.max(0f, down(from)));
        return true;
    }

    private static float inverse(double d) {
        return (float) Math.max(-STEEPEST, Math.min(STEEPEST, 1 / d));
    }

    /** Whether a scene with this largest absolute coordinate is in range. */
    public static boolean suits(double reach) {
        return reach <= LARGEST && reach >= SMALLEST;
    }

    /** The margin by which half extents of boxes are widened. */
    public static double widening(double reach) {
        return WIDENING * reach;
    }

    /**
     * The t at which the ray enters a box, at least tMin, as bits of a float; the box's numbers (x, y, z of centre and half extents) begin
     * at b[k] and lie two apart. {@link #MISS} if the ray misses the box or enters it beyond the limit, which is also given as the bits of
     * a float.
     */
    public int entry(float[] b, int k, int limit) {
        float mx = Math.fma(b[k], invX, offsetX);
        float my = Math.fma(b[k + 2], invY, offsetY);
        float mz = Math.fma(b[k + 4], invZ, offsetZ);
        float hx = b[k + 6];
        float hy = b[k + 8];
        float hz = b[k + 10];
        int nx = Float.floatToRawIntBits(Math.fma(-hx, sizeX, mx));
        int ny = Float.floatToRawIntBits(Math.fma(-hy, sizeY, my));
        int nz = Float.floatToRawIntBits(Math.fma(-hz, sizeZ, mz));
        int fx = Float.floatToRawIntBits(Math.fma(hx, sizeX, mx));
        int fy = Float.floatToRawIntBits(Math.fma(hy, sizeY, my));
        int fz = Float.floatToRawIntBits(Math.fma(hz, sizeZ, mz));
        int near = Math.max(Math.max(nx, ny), Math.max(nz, tMin));
        int far = Math.min(Math.min(fx, fy), Math.min(fz, limit));
        return near <= far ? near : MISS;
    }

    /** A limit of t for {@link #entry}; of a negative one, and of no other, the bits are negative. */
    public static int limit(double t) {
        return Float.floatToRawIntBits(up(t) + 0f);
    }

    /** The largest float that is not greater than the double. */
    public static float down(double v) {
        float f = (float) v;
        return f > v ? Math.nextDown(f) : f;
    }

    /** The smallest float that is not less than the double; infinity beyond the range. */
    public static float up(double v) {
        float f = (float) v;
        return f < v ? Math.nextUp(f) : f;
    }
}

package enlightenment.accel;

import enlightenment.primitive.Ray;

/**
 * The test of a ray against boxes of floats that were rounded outwards. It is conservative: a box that contains an intersection is
 * never missed.
 *
 * <p><b>Roundings.</b> Let m be the largest absolute coordinate of origin and boxes together, u = 2^-24. The origin is moved by w ≥ 8um
 * towards the outside of each face before it is rounded to a float (an error of um), the difference to a face is rounded (relative u), so
 * are the inverse and the product. In space these are less than um + 3u·2m &lt; 8um, and the rest covers the roundings of the primitives'
 * own tests, which are of the order of 2^-46 m. Best t so far and limit are rounded up, tMin down.
 *
 * <p><b>Range.</b> {@link #set} refuses rays whose direction or origin is so large or small that an inverse or a product could leave
 * the normal range of floats, but for components of the direction that are tiny beside the others: their inverse may overflow, and
 * the slab's times become infinite, as for a ray parallel to the axis. That is right: along such an axis the ray does not move by w within
 * the scene.
 *
 * <p><b>Order.</b> A time that matters is not negative, and floats that are not negative are ordered as their bits are ordered as ints; a
 * negative entry loses against tMin ≥ 0, a negative exit makes the smallest exit negative: a miss. Comparing ints takes one
 * instruction where {@link Math#max(float, float)} takes five. 0·∞ is NaN, of a sign that depends on the machine: it arises
 * only where a parallel ray runs exactly w outside a face; then the box is rejected or not, and either is right.
 */
final class FloatSlabs {
    /** What {@link #entry} returns for a box that the ray misses: more than the bits of infinity. */
    static final int MISS = Integer.MAX_VALUE;

    /** Squared lengths of directions, and coordinates, for which nothing leaves the range of floats. */
    static final double LARGEST = 0x1p40;

    private static final double SMALLEST = 0x1p-40;

    /** w relative to m; twice what is needed. */
    private static final double WIDENING = 0x1p-20;

    private float nearX;
    private float farX;
    private float invX;
    private int nearAtX;
    private int farAtX;
    private float nearY;
    private float farY;
    private float invY;
    private int nearAtY;
    private int farAtY;
    private float nearZ;
    private float farZ;
    private float invZ;
    private int nearAtZ;
    private int farAtZ;
    private int tMin;

    /**
     * Prepares the test.
     *
     * @param ray the ray
     * @param reach the largest absolute coordinate of any box, in the range that {@link #suits} asks for
     * @return whether this test is right for the ray
     */
    boolean set(Ray ray, double reach) {
        double m = Math.max(Math.max(Math.abs(ray.ox), Math.abs(ray.oy)), Math.max(Math.abs(ray.oz), reach));
        if (!(ray.dd >= SMALLEST && ray.dd <= LARGEST && m <= LARGEST && ray.tMin >= 0)) {
            return false;
        }
        double w = WIDENING * m;
        invX = (float) (1 / ray.dx);
        invY = (float) (1 / ray.dy);
        invZ = (float) (1 / ray.dz);
        boolean backX = invX < 0;
        boolean backY = invY < 0;
        boolean backZ = invZ < 0;
        nearX = (float) (backX ? ray.ox - w : ray.ox + w);
        farX = (float) (backX ? ray.ox + w : ray.ox - w);
        nearY = (float) (backY ? ray.oy - w : ray.oy + w);
        farY = (float) (backY ? ray.oy + w : ray.oy - w);
        nearZ = (float) (backZ ? ray.oz - w : ray.oz + w);
        farZ = (float) (backZ ? ray.oz + w : ray.oz - w);
        // Where the faces lie in a node: see FloatBvh.
        nearAtX = backX ? 6 : 0;
        farAtX = 6 - nearAtX;
        nearAtY = backY ? 8 : 2;
        farAtY = 10 - nearAtY;
        nearAtZ = backZ ? 10 : 4;
        farAtZ = 14 - nearAtZ;
        tMin = Float.floatToRawIntBits(Math.max(0f, down(ray.tMin)));
        return true;
    }

    /** Whether a scene with this largest absolute coordinate is in range. */
    static boolean suits(double reach) {
        return reach <= LARGEST && reach >= SMALLEST;
    }

    /**
     * Where the ray enters the box whose numbers begin at b[k] and lie two apart, at least tMin, as bits of a float; {@link #MISS} if it
     * misses the box or enters it beyond the limit, which is the bits of a float too.
     */
    int entry(float[] b, int k, int limit) {
        int nx = Float.floatToRawIntBits((b[k + nearAtX] - nearX) * invX);
        int ny = Float.floatToRawIntBits((b[k + nearAtY] - nearY) * invY);
        int nz = Float.floatToRawIntBits((b[k + nearAtZ] - nearZ) * invZ);
        int fx = Float.floatToRawIntBits((b[k + farAtX] - farX) * invX);
        int fy = Float.floatToRawIntBits((b[k + farAtY] - farY) * invY);
        int fz = Float.floatToRawIntBits((b[k + farAtZ] - farZ) * invZ);
        int near = Math.max(Math.max(nx, ny), Math.max(nz, tMin));
        int far = Math.min(Math.min(fx, fy), Math.min(fz, limit));
        return near <= far ? near : MISS;
    }

    /** A limit of t, not negative, for {@link #entry}. */
    static int limit(double t) {
        return Float.floatToRawIntBits(up(t));
    }

    /** The largest float that is not greater. */
    static float down(double v) {
        float f = (float) v;
        return f > v ? Math.nextDown(f) : f;
    }

    /** The smallest float that is not less; infinity beyond the range. */
    static float up(double v) {
        float f = (float) v;
        return f < v ? Math.nextUp(f) : f;
    }
}

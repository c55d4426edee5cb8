package enlightenment.bvh;

/**
 * The test of a shaft, all segments from a point P to a box, against boxes of floats that were rounded outwards. At the
 * share s of their way the segments fill the box P + s·(L − P), L being the box at their end; it overlaps another box on an axis
 * for s in an interval, so the shaft meets that box if the three intervals and [0, 1] have a point in common. No square root is taken.
 *
 * <p>The test is conservative. With m the largest absolute coordinate of P, L and the boxes, P is moved by w = 2^-19 m towards the outside
 * of each face, and L is widened by w. The roundings of a face and of its distance from P are less than 5·2^-24 m; the factors
 * {@link #LESS} and {@link #MORE} cover the roundings of quotients once more.
 */
public final class FloatShaft {
    private static final double WIDENING = 0x1p-19;
    private static final float LESS = 1 - 0x1p-20f;
    private static final float MORE = 1 + 0x1p-20f;

    /** An upper limit where the axis sets none. */
    private static final float FAR = 0x1p60f;

    private static final int ONE = Float.floatToRawIntBits(1 + 0x1p-12f);

    /** By axis: P for lower faces and for upper faces. */
    private float lowerX;

    private float upperX;
    private float lowerY;
    private float upperY;
    private float lowerZ;
    private float upperZ;

    /** By axis: times the distance to a lower and an upper face, the least s; 0 where the face sets none. */
    private float leastLowerX;

    private float leastUpperX;
    private float leastLowerY;
    private float leastUpperY;
    private float leastLowerZ;
    private float leastUpperZ;

    /** By axis: which face (upper 1, lower −1) sets the largest s, P for it, and what the distance is multiplied by. */
    private float faceX;

    private float mostX;
    private float mostInvX;
    private float faceY;
    private float mostY;
    private float mostInvY;
    private float faceZ;
    private float mostZ;
    private float mostInvZ;

    /** A shaft to be {@link #set} before use. */
    public FloatShaft() {}

    /**
     * Prepares the test.
     *
     * @param px the point: px, py, pz
     * @param ends the box at the end of the segments: least, then largest coordinates
     * @param reach the largest absolute coordinate of any box, such that {@link FloatSlabs#suits}
     * @return whether this test is right for the shaft
     */
    public boolean set(double px, double py, double pz, double[] ends, double reach) {
        double m = Math.max(reach, Math.max(Math.abs(px), Math.max(Math.abs(py), Math.abs(pz))));
        for (int k = 0; k < ItemBoxes.BOX; k++) {
            m = Math.max(m, Math.abs(ends[k]));
        }
        if (!(m <= FloatSlabs.LARGEST)) {
            return false;
        }
        double w = WIDENING * m;
        setX(px, ends[0] - w - px, ends[3] + w - px, w);
        setY(py, ends[1] - w - py, ends[4] + w - py, w);
        setZ(pz, ends[2] - w - pz, ends[5] + w - pz, w);
        return true;
    }

    private void setX(double p, double low, double high, double w) {
        lowerX = (float) (p + w);
        upperX = (float) (p - w);
        leastLowerX = leastLower(high, w);
        leastUpperX = leastUpper(low, w);
        faceX = low > w ? 1 : -1;
        mostX = low > w ? upperX : high < -w ? lowerX : -FAR;
        mostInvX = most(low, high, w);
    }

    private void setY(double p, double low, double high, double w) {
        lowerY = (float) (p + w);
        upperY = (float) (p - w);
        leastLowerY = leastLower(high, w);
        leastUpperY = leastUpper(low, w);
        faceY = low > w ? 1 : -1;
        mostY = low > w ? upperY : high < -w ? lowerY : -FAR;
        mostInvY = most(low, high, w);
    }

    private void setZ(double p, double low, double high, double w) {
        lowerZ = (float) (p + w);
        upperZ = (float) (p - w);
        leastLowerZ = leastLower(high, w);
        leastUpperZ = leastUpper(low, w);
        faceZ = low > w ? 1 : -1;
        mostZ = low > w ? upperZ : high < -w ? lowerZ : -FAR;
        mostInvZ = most(low, high, w);
    }

    /** s·high reaches the lower face from s = (face − P)/high on, if the shaft goes up at all. */
    private static float leastLower(double high, double w) {
        return high > 0 ? (float) (1 / Math.max(high, w)) * LESS : 0;
    }

    /** s·low reaches the upper face from s = (face − P)/low on, if the shaft goes down at all. */
    private static float leastUpper(double low, double w) {
        return low < 0 ? (float) (1 / Math.min(low, -w)) * LESS : 0;
    }

    /** A shaft that only goes up passes the upper face, one that only goes down the lower one, at (face − P) times this. */
    private static float most(double low, double high, double w) {
        return low > w ? (float) (1 / low) * MORE : high < -w ? (float) (1 / high) * MORE : 1;
    }

    /** Whether the shaft may meet the box whose numbers (centre and half extents) begin at b[k] and lie two apart. */
    public boolean meets(float[] b, int k) {
        float cx = b[k];
        float cy = b[k + 2];
        float cz = b[k + 4];
        float hx = b[k + 6];
        float hy = b[k + 8];
        float hz = b[k + 10];
        int lx = Float.floatToRawIntBits((cx - hx - lowerX) * leastLowerX);
        int ux = Float.floatToRawIntBits((cx + hx - upperX) * leastUpperX);
        int mx = Float.floatToRawIntBits((Math.fma(hx, faceX, cx) - mostX) * mostInvX);
        int ly = Float.floatToRawIntBits((cy - hy - lowerY) * leastLowerY);
        int uy = Float.floatToRawIntBits((cy + hy - upperY) * leastUpperY);
        int my = Float.floatToRawIntBits((Math.fma(hy, faceY, cy) - mostY) * mostInvY);
        int lz = Float.floatToRawIntBits((cz - hz - lowerZ) * leastLowerZ);
        int uz = Float.floatToRawIntBits((cz + hz - upperZ) * leastUpperZ);
        int mz = Float.floatToRawIntBits((Math.fma(hz, faceZ, cz) - mostZ) * mostInvZ);
        int least = Math.max(Math.max(Math.max(lx, ux), Math.max(ly, uy)), Math.max(Math.max(lz, uz), 0));
        int most = Math.min(Math.min(mx, my), Math.min(mz, ONE));
        return least <= most;
    }
}

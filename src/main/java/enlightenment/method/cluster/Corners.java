package enlightenment.method.cluster;

/** Results of rays through the corners of a block's pixels: for each a colour, and a key of the surfaces that it met. */
public abstract class Corners {
    /** A key that no path has, but for a chance of 2⁻⁶⁴. */
    public static final long DIFFERENT = Long.MIN_VALUE;

    /** The number of corners along a side of the largest block. */
    public final int side;

    /** The number of corners of the largest block. */
    public final int nodes;

    /** Red, green and blue of each corner, row by row. */
    public final double[] rgb;

    public final long[] keys;

    /**
     * @param blockSide of the largest block, in pixels
     */
    public Corners(int blockSide) {
        side = blockSide + 1;
        nodes = side * side;
        rgb = new double[3 * nodes];
        keys = new long[nodes];
    }

    public final int node(int i, int j) {
        return side * j + i;
    }

    /** The key of all four corners of a pixel, or {@link #DIFFERENT} if they have different ones. */
    public final long commonKey(int i, int j) {
        int k = node(i, j);
        int below = k + side;
        long key = keys[k];
        return key == keys[k + 1] && key == keys[below] && key == keys[below + 1] ? key : DIFFERENT;
    }
}

package enlightenment.method.cluster;

/** What rays through the corners of a block's pixels have seen: a colour for each, and a key of what it met. */
public abstract class Corners {
    /** No path's key, but for one in 2⁶⁴. */
    public static final long DIFFERENT = Long.MIN_VALUE;

    /** How many there are along a side of the block. */
    public final int side;

    /** How many there are. */
    public final int nodes;

    /** Red, green and blue of each corner, row by row. */
    public final double[] rgb;

    public final long[] keys;

    /** @param blockSide of the largest block, in pixels */
    public Corners(int blockSide) {
        side = blockSide + 1;
        nodes = side * side;
        rgb = new double[3 * nodes];
        keys = new long[nodes];
    }

    public final int node(int i, int j) {
        return side * j + i;
    }

    /** What all corners of a pixel met, or {@link #DIFFERENT} if they did not meet the same. */
    public final long commonKey(int i, int j) {
        int k = node(i, j);
        int below = k + side;
        long key = keys[k];
        return key == keys[k + 1] && key == keys[below] && key == keys[below + 1] ? key : DIFFERENT;
    }
}

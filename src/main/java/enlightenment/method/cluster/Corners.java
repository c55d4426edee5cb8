package enlightenment.method.cluster;

import enlightenment.film.FilmTile;

/** What rays through the corners of a block's pixels have seen: a colour for each, and a key of what it met. */
abstract class Corners {
    static final int SIDE = FilmTile.BLOCK_SIDE + 1;

    static final int NODES = SIDE * SIDE;

    /** No path's key, but for one in 2⁶⁴. */
    static final long DIFFERENT = Long.MIN_VALUE;

    /** Red, green and blue of each corner, row by row. */
    final double[] rgb = new double[3 * NODES];

    final long[] keys = new long[NODES];

    static int node(int i, int j) {
        return SIDE * j + i;
    }

    /** What all corners of a pixel met, or {@link #DIFFERENT} if they did not meet the same. */
    final long commonKey(int i, int j) {
        int k = node(i, j);
        int below = k + SIDE;
        long key = keys[k];
        return key == keys[k + 1] && key == keys[below] && key == keys[below + 1] ? key : DIFFERENT;
    }
}

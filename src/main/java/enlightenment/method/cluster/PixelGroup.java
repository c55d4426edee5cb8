package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.sampling.Hash;

/**
 * A quarter of the pixels of a block, one of each 2 × 2. Were the block a chessboard, two groups have the fields of each colour; which of
 * the two fields of its colour in 2 × 2 pixels a group has is random for each. So groups are interleaved, their errors average out over few
 * pixels, and there is no visible pattern. Mutable, one per thread.
 */
final class PixelGroup {
    /** The number of groups of a block: two of each colour. */
    static final int COUNT = 4;

    private static final int COLOURS = 2;

    /** Mixed into hashes, so that groups share no random numbers with others. */
    private static final long PURPOSE = 0x67726F757073L;

    /** The largest number of pixels in a group. */
    static final int MOST_MEMBERS = PhysicalClusterMethod.PIXELS / COUNT;

    /** The chessboard colour of the group, 0 or 1. */
    int field;

    /** The number of pixels in the group. */
    int members;

    /** By member: its column and row in the block. */
    final int[] column = new int[MOST_MEMBERS];

    final int[] row = new int[MOST_MEMBERS];

    private Block block;
    private int number;

    /** Makes this the group of a block with this number. */
    void gather(Block of, int numbered) {
        block = of;
        number = numbered;
        field = number % COLOURS;
        int second = number / COLOURS;
        members = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = (j ^ field) & 1; i < block.width(); i += COLOURS) {
                if (((j ^ turn(block.x() + i >> 1, block.y() + j >> 1)) & 1) == second) {
                    column[members] = i;
                    row[members++] = j;
                }
            }
        }
    }

    /** 0 or 1: whether the first group of the colour has its upper or its lower field in these 2 × 2 pixels of the picture. */
    private int turn(int x, int y) {
        return (int) (Hash.of(PURPOSE, x, y) >>> field) & 1;
    }

    /** A 64-bit hash that identifies the group in the whole picture. */
    long hash(long seed) {
        return Hash.of(Hash.of(seed, number), block.x(), block.y());
    }

    /** The column of a member in the whole picture. */
    int x(int m) {
        return block.x() + column[m];
    }

    /** The row of a member in the whole picture. */
    int y(int m) {
        return block.y() + row[m];
    }

    /** The index of a member among all pixels of a block. */
    int inBlock(int m) {
        return PhysicalClusterMethod.BLOCK_SIDE * row[m] + column[m];
    }

    /** Whether any member belongs to the tile. */
    boolean overlaps(FilmTile tile) {
        for (int m = 0; m < members; m++) {
            if (tile.contains(x(m), y(m))) {
                return true;
            }
        }
        return false;
    }
}

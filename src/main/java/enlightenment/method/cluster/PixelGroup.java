package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.sampling.Hash;

/**
 * A quarter of the pixels of a block: of each 2 × 2 pixels one. Two groups have the pixels that are fields of one colour, were the block a
 * chessboard; which of the two fields of its colour in 2 × 2 pixels a group has is drawn for each of these. So groups are interleaved,
 * their errors average out over few pixels, and there is no pattern that the eye could follow. Mutable, one per thread.
 */
final class PixelGroup {
    /** How many groups a block has: two of each colour. */
    static final int COUNT = 4;

    private static final int COLOURS = 2;

    /** Keeps what is drawn here apart from all other random numbers. */
    private static final long PURPOSE = 0x67726F757073L;

    /** How many pixels a group has at most. */
    static final int MOST_MEMBERS = PhysicalClusterMethod.PIXELS / COUNT;

    /** The colour, 0 or 1. */
    int field;

    /** How many pixels the group has. */
    int members;

    /** Where they are in the block. */
    final int[] column = new int[MOST_MEMBERS];

    final int[] row = new int[MOST_MEMBERS];

    private Block block;
    private int number;

    /** Makes it the group of a block with this number. */
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

    /** 0 or 1: whether the first group of the colour has the upper or the lower field of it in these 2 × 2 pixels of the picture. */
    private int turn(int x, int y) {
        return (int) (Hash.of(PURPOSE, x, y) >>> field) & 1;
    }

    /** A 64-bit hash of which group of the whole picture it is. */
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

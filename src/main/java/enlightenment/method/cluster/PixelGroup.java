package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;

/**
 * Some of the pixels of a block that are fields of one colour, were it a chessboard, and lie in fields of one colour of a chessboard of
 * 2 × 2 pixels: so the groups lie between each other. Mutable, one per thread.
 */
final class PixelGroup {
    /** How many groups a block has: two of each colour. */
    static final int COUNT = 4;

    private static final int COLOURS = 2;

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

    /** Makes it the group of a block with this number. */
    void gather(Block of, int number) {
        block = of;
        field = number % COLOURS;
        int half = number / COLOURS;
        members = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = (j ^ field) & 1; i < block.width(); i += COLOURS) {
                if (((i ^ j) >> 1 & 1) == half) {
                    column[members] = i;
                    row[members++] = j;
                }
            }
        }
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

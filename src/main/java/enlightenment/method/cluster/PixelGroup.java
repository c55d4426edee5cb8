package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;

/**
 * Some pixels of a block, evenly spread over it: every other pixel of every other row, and those between. Mutable, one per thread. The
 * groups of a block are numbered; each pixel belongs to one.
 */
final class PixelGroup {
    /** How many groups a block has. */
    static final int COUNT = 8;

    /** How many pixels a group has at most. */
    static final int MOST_MEMBERS = FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE / COUNT;

    private static final int STEP = 4;

    /** How many pixels the group has. */
    int members;

    /** Where they are in the block. */
    final int[] column = new int[MOST_MEMBERS];

    final int[] row = new int[MOST_MEMBERS];

    private Block block;

    /** Makes it the group of a block with this number. */
    void gather(Block of, int number) {
        block = of;
        members = 0;
        for (int j = number / STEP; j < block.height(); j += STEP / 2) {
            int shift = (j - number / STEP) % STEP;
            for (int i = (number + shift) % STEP; i < block.width(); i += STEP) {
                column[members] = i;
                row[members++] = j;
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
        return FilmTile.BLOCK_SIDE * row[m] + column[m];
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

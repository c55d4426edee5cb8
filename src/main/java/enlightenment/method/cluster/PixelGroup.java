package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.sampling.Hash;

/**
 * 64 of the pixels of a block, one of each cell: of a block of 16 × 16 pixels one of each 2 × 2, of one of 32 × 32 one of each 4 × 4. Were
 * the block a chessboard, all pixels of a group would be on fields of one colour; which of those of a cell a group has is random. So groups
 * are interleaved, their errors average out over few pixels, and there is no visible pattern. Mutable, one per thread.
 */
final class PixelGroup {
    /** The largest number of pixels in a group. */
    static final int MOST_MEMBERS = 64;

    private static final int CELLS_ACROSS = 8;

    private static final int COLOURS = 2;

    /** Mixed into hashes, so that groups share no random numbers with others. */
    private static final long PURPOSE = 0x67726F757073L;

    /** The number of groups of a block: as many of each colour. */
    final int count;

    /** The chessboard colour of the group, 0 or 1. */
    int field;

    /** The number of pixels in the group. */
    int members;

    /** By member: its column and row in the block. */
    final int[] column = new int[MOST_MEMBERS];

    final int[] row = new int[MOST_MEMBERS];

    private final int blockSide;

    /** Side of a cell, in pixels. */
    private final int cell;

    /** The fields of a colour in a cell, in a random order: that of the groups which have them. */
    private final int[] order;

    private Block block;
    private int number;

    /**
     * @param blockSide of the largest block, in pixels; 16, 32 or 64
     */
    PixelGroup(int blockSide) {
        this.blockSide = blockSide;
        cell = blockSide / CELLS_ACROSS;
        count = cell * cell;
        order = new int[count / COLOURS];
    }

    /** Makes this the group of a block with this number. */
    void gather(Block of, int numbered) {
        block = of;
        number = numbered;
        field = number % COLOURS;
        int place = number / COLOURS;
        members = 0;
        for (int j = 0; j < block.height(); j += cell) {
            for (int i = 0; i < block.width(); i += cell) {
                shuffle(Hash.of(Hash.of(PURPOSE, field), block.x() + i, block.y() + j));
                add(i, j, order[place]);
            }
        }
    }

    /** Puts the fields of a cell in a random order. */
    private void shuffle(long hash) {
        long bits = hash;
        for (int k = 0; k < order.length; k++) {
            // As a fraction of 2³²: what this is short of uniform is below 2⁻²⁶.
            int other = (int) ((bits >>> Integer.SIZE) * (k + 1) >>> Integer.SIZE);
            order[k] = order[other];
            order[other] = k;
            bits = Hash.mix(bits);
        }
    }

    /** Adds a field of the group's colour of the cell that begins here, if the picture does not end before it. */
    private void add(int left, int top, int which) {
        int j = which * COLOURS / cell;
        int i = which * COLOURS % cell + (j + field) % COLOURS;
        if (left + i < block.width() && top + j < block.height()) {
            column[members] = left + i;
            row[members++] = top + j;
        }
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
        return blockSide * row[m] + column[m];
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

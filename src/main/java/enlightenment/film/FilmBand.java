package enlightenment.film;

import java.nio.ByteBuffer;

/** Some rows of blocks of pixels, as a {@link FilmInFile} keeps them. */
final class FilmBand {
    /** Side of the blocks, of which each has its pixels together, row by row. */
    static final int SIDE = FilmTile.BLOCK_SIDE;

    /** Offsets of the numbers within a pixel. */
    private static final int HALVES = 3 * Double.BYTES;

    private static final int QUARTERS = HALVES + Float.BYTES;
    private static final int COUNT = QUARTERS + Float.BYTES;
    private static final int OF_QUARTERS = COUNT + Integer.BYTES;

    private final ByteBuffer bytes;
    private final int firstColumn;
    private final int pixelBytes;

    /** @param firstColumn that of the first block, in the whole picture */
    FilmBand(byte[] bytes, int firstColumn, int pixelBytes) {
        this.bytes = ByteBuffer.wrap(bytes);
        this.firstColumn = firstColumn;
        this.pixelBytes = pixelBytes;
    }

    /** The number of a pixel within its row of blocks, whose first column is that of a block. */
    static int index(int column, int row) {
        return SIDE * SIDE * (column / SIDE) + SIDE * (row % SIDE) + column % SIDE;
    }

    private int at(int column, int row) {
        return pixelBytes * index(column - firstColumn, row);
    }

    int count(int column, int row) {
        return bytes.getInt(at(column, row) + COUNT);
    }

    double component(int column, int row, int c) {
        return bytes.getDouble(at(column, row) + Double.BYTES * c);
    }

    float halves(int column, int row) {
        return bytes.getFloat(at(column, row) + HALVES);
    }

    float quarters(int column, int row) {
        return bytes.getFloat(at(column, row) + QUARTERS);
    }

    void quarterMeans(int column, int row, double[] out) {
        int at = at(column, row) + OF_QUARTERS;
        for (int i = 0; i < QuarterMeans.PER_PIXEL; i++) {
            out[i] = bytes.getFloat(at + Float.BYTES * i);
        }
    }
}

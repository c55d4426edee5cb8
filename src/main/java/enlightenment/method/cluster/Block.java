package enlightenment.method.cluster;

import enlightenment.film.FilmTile;

/**
 * A rectangle of pixels that is sampled as one: 8 × 8, fixed by the picture and never by threads or crops; smaller at its
 * right and lower border.
 *
 * @param x first column
 * @param y first row
 * @param width columns, 1..8
 * @param height rows, 1..8
 */
record Block(int x, int y, int width, int height) {
    static final int SIDE = FilmTile.BLOCK_SIDE;

    /** The block that a pixel of a picture belongs to. */
    static Block around(int column, int row, int pictureWidth, int pictureHeight) {
        int x = column / SIDE * SIDE;
        int y = row / SIDE * SIDE;
        return new Block(x, y, Math.min(SIDE, pictureWidth - x), Math.min(SIDE, pictureHeight - y));
    }
}

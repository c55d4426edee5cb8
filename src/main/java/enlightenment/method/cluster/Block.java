package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.SpreadPlaces;
import java.util.ArrayList;
import java.util.List;

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

    /** This many blocks of a picture, or all of them if there are no more, evenly spread over it. */
    static List<Block> spread(int pictureWidth, int pictureHeight, int count) {
        int across = (pictureWidth + SIDE - 1) / SIDE;
        int down = (pictureHeight + SIDE - 1) / SIDE;
        List<Block> blocks = new ArrayList<>();
        for (int[] place : SpreadPlaces.of(across, down, count)) {
            blocks.add(Block.around(place[0] * SIDE, place[1] * SIDE, pictureWidth, pictureHeight));
        }
        return blocks;
    }
}

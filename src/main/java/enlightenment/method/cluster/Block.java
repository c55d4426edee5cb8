package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.method.SpreadPlaces;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

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

    /** Visits the blocks that pixels of a tile belong to, row by row. */
    static void forEach(FilmTile tile, int pictureWidth, int pictureHeight, Consumer<Block> visitor) {
        int right = tile.x + tile.width;
        int bottom = tile.y + tile.height;
        for (int y = tile.y / SIDE * SIDE; y < bottom; y += SIDE) {
            for (int x = tile.x / SIDE * SIDE; x < right; x += SIDE) {
                visitor.accept(around(x, y, pictureWidth, pictureHeight));
            }
        }
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

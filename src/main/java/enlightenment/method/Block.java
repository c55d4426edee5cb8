package enlightenment.method;

import enlightenment.film.FilmTile;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A rectangle of pixels that is rendered as one: a square that is fixed by the picture and never by threads or crops; smaller at the
 * picture's right and lower border.
 *
 * @param x first column
 * @param y first row
 * @param width columns, 1 and more
 * @param height rows, 1 and more
 */
public record Block(int x, int y, int width, int height) {
    /**
     * The block that a pixel of a picture belongs to.
     *
     * @param side of all blocks, in pixels
     */
    public static Block around(int column, int row, int pictureWidth, int pictureHeight, int side) {
        int x = column / side * side;
        int y = row / side * side;
        return new Block(x, y, Math.min(side, pictureWidth - x), Math.min(side, pictureHeight - y));
    }

    /**
     * Visits the blocks that pixels of a tile belong to, row by row.
     *
     * @param side of all blocks, in pixels
     */
    public static void forEach(FilmTile tile, int pictureWidth, int pictureHeight, int side, Consumer<Block> visitor) {
        int right = tile.x + tile.width;
        int bottom = tile.y + tile.height;
        for (int y = tile.y / side * side; y < bottom; y += side) {
            for (int x = tile.x / side * side; x < right; x += side) {
                visitor.accept(around(x, y, pictureWidth, pictureHeight, side));
            }
        }
    }

    /**
     * This many blocks of a picture, or all of them if there are no more, evenly spread over it.
     *
     * @param side of all blocks, in pixels
     */
    public static List<Block> spread(int pictureWidth, int pictureHeight, int side, int count) {
        int across = (pictureWidth + side - 1) / side;
        int down = (pictureHeight + side - 1) / side;
        List<Block> blocks = new ArrayList<>();
        for (int[] place : SpreadPlaces.of(across, down, count)) {
            blocks.add(around(place[0] * side, place[1] * side, pictureWidth, pictureHeight, side));
        }
        return blocks;
    }

    /** How many pixels it has. */
    public int pixels() {
        return width * height;
    }
}

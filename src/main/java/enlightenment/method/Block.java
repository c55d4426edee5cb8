package enlightenment.method;

import enlightenment.film.FilmTile;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A rectangle of pixels that is rendered as one: a square on a grid fixed by the picture, never by threads or crops; cut off at the
 * picture's right and lower edges.
 *
 * @param x first column
 * @param y first row
 * @param width columns, at least 1
 * @param height rows, at least 1
 */
public record Block(int x, int y, int width, int height) {
    /**
     * The block of a picture that contains a pixel.
     *
     * @param side of all blocks, in pixels
     */
    public static Block around(int column, int row, int pictureWidth, int pictureHeight, int side) {
        int x = column / side * side;
        int y = row / side * side;
        return new Block(x, y, Math.min(side, pictureWidth - x), Math.min(side, pictureHeight - y));
    }

    /**
     * Visits the blocks that overlap a tile, row by row.
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
     * A subset of a picture's blocks of this size, evenly spread over it; all of them if there are no more.
     *
     * @param side of all blocks, in pixels
     * @param count the number of blocks
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

    /** The number of pixels. */
    public int pixels() {
        return width * height;
    }
}

package enlightenment.method.metropolis;

import enlightenment.film.FilmTile;
import enlightenment.scene.MetropolisSettings;
import java.util.function.Consumer;

/**
 * A rectangle of pixels that chains live in: 64 × 64, fixed by the picture and never by threads or crops; smaller at its right and
 * lower border.
 *
 * @param x first column
 * @param y first row
 * @param width columns, 1..64
 * @param height rows, 1..64
 */
record Block(int x, int y, int width, int height) {
    static final int SIDE = MetropolisSettings.BLOCK_SIDE;

    /** Visits the blocks that pixels of a tile belong to, row by row. */
    static void forEach(FilmTile tile, int pictureWidth, int pictureHeight, Consumer<Block> visitor) {
        for (int y = tile.y / SIDE * SIDE; y < tile.y + tile.height; y += SIDE) {
            for (int x = tile.x / SIDE * SIDE; x < tile.x + tile.width; x += SIDE) {
                visitor.accept(new Block(x, y, Math.min(SIDE, pictureWidth - x), Math.min(SIDE, pictureHeight - y)));
            }
        }
    }

    int pixels() {
        return width * height;
    }
}

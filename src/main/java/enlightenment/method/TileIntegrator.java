package enlightenment.method;

import enlightenment.film.FilmTile;
import enlightenment.film.TileGrowth;
import enlightenment.film.TilePasses;

/**
 * Chooses samples in the pixels of a tile, and makes pixels of them. What becomes of a tile is a pure function of scene, settings,
 * plan, tile and pass.
 *
 * <p>Where pixels have many samples, a tile may be made in passes: a pass takes a consecutive part of each pixel's samples, and is a
 * piece of work that may be done anywhere. {@link TilePasses} puts the tile together.
 */
public non-sealed interface TileIntegrator extends Integrator {
    /**
     * Whether samples of a pixel can be taken apart from those before. If not, there is only one pass.
     */
    boolean dividesIntoPasses();

    /**
     * Renders a pass of a tile: of each pixel's n samples those with the indices in [⌈n · pass/passes⌉, ⌈n · (pass + 1)/passes⌉).
     * A tile made in one pass is finished; otherwise only its sums and counts are of use ({@link TilePasses}).
     *
     * @param tile without samples
     * @param pass 0 to passes − 1
     * @param passes 1, or where this {@link #dividesIntoPasses} a power of two from 4 on that is no more than the samples of any pixel
     * @throws IllegalArgumentException for another number of passes
     * @throws java.util.concurrent.CancellationException as {@link #stopWhen} tells; the tile is then of no use
     */
    void render(FilmTile tile, int pass, int passes);

    /**
     * How many samples a pixel has; 0 where they are chosen otherwise than one after another, so that a tile with some of them cannot
     * {@linkplain #grow grow}.
     */
    default int samples(int column, int row) {
        return 0;
    }

    /**
     * Renders a tile in one pass, with those samples of each pixel that are not there yet: the same bits as if all were taken here.
     *
     * @param tile without samples
     * @param growth what is there, and receives what is there then. Of pixels that have all of their samples already only sums and
     *     counts are put into the tile
     */
    default void grow(FilmTile tile, TileGrowth growth) {
        throw new UnsupportedOperationException();
    }

    /** Renders a tile in one pass. */
    default void render(FilmTile tile) {
        render(tile, 0, 1);
    }

    /** Renders a tile in all its passes: the same bits as if each was made somewhere else. */
    default void renderAll(FilmTile tile, int passes) {
        if (passes == 1) {
            render(tile, 0, 1);
            return;
        }
        TilePasses all = new TilePasses(tile.x, tile.y, tile.width, tile.height, passes);
        for (int pass = 0; pass < passes; pass++) {
            FilmTile one = tile.like(tile.x, tile.y, tile.width, tile.height);
            render(one, pass, passes);
            all.add(pass, one);
        }
        all.into(tile);
    }
}

package enlightenment.method;

import enlightenment.film.FilmTile;
import enlightenment.film.TileGrowth;
import enlightenment.film.TilePasses;

/**
 * Takes samples in the pixels of a tile and turns them into pixels. The result is a pure function of scene, settings, plan, tile and pass.
 *
 * <p>Where pixels have many samples, a tile may be rendered in passes: a pass takes a consecutive part of each pixel's samples, and is a
 * unit of work of its own. {@link TilePasses} puts the tile together.
 */
public non-sealed interface TileIntegrator extends Integrator {
    /** Whether samples of a pixel can be taken independently of those before. If not, there is only one pass. */
    boolean dividesIntoPasses();

    /**
     * Renders a pass of a tile: of each pixel's n samples those with the indices in [⌈n · pass/passes⌉, ⌈n · (pass + 1)/passes⌉). A tile
     * rendered in one pass is finished; otherwise only its sums and counts are of use ({@link TilePasses}).
     *
     * @param tile without samples
     * @param pass 0 to passes − 1
     * @param passes 1, or where this {@link #dividesIntoPasses} a power of two, at least 4, that is at most the number of samples of any
     *     pixel
     * @throws IllegalArgumentException for another number of passes
     * @throws java.util.concurrent.CancellationException once the condition of {@link #stopWhen} holds; the tile is then of no use
     */
    void render(FilmTile tile, int pass, int passes);

    /**
     * The number of samples of a pixel; 0 where samples are not taken one after another, so that a tile with some of them cannot
     * {@linkplain #grow grow}.
     */
    default int samples(int column, int row) {
        return 0;
    }

    /**
     * Renders a tile in one pass, with only those samples of each pixel that do not exist yet: the same bits as if all were taken here.
     *
     * @param tile without samples
     * @param growth has the samples taken before, and receives all taken then; pixels that are complete already get only sums and counts in
     *     the tile
     */
    default void grow(FilmTile tile, TileGrowth growth) {
        throw new UnsupportedOperationException();
    }

    /** Renders a tile in one pass. */
    default void render(FilmTile tile) {
        render(tile, 0, 1);
    }

    /** Renders a tile in all its passes: the same bits as if each was rendered elsewhere. */
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

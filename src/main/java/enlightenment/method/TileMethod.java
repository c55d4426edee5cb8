package enlightenment.method;

import enlightenment.film.FilmTile;
import java.util.function.BooleanSupplier;

/**
 * A way to choose samples and to make pixels of them. One per thread; a tile is a pure function of scene, settings, plan
 * and tile.
 */
public interface TileMethod {
    /**
     * Renders the pixels of a tile.
     *
     * @throws java.util.concurrent.CancellationException as {@link #stopWhen} tells; the tile is then of no use
     */
    void render(FilmTile tile);

    /** Lets {@link #render} end in the middle of a tile, soon after this has become true; it stays true then. */
    void stopWhen(BooleanSupplier cancelled);
}

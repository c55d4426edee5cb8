package enlightenment.method;

import enlightenment.film.FilmTile;

/**
 * A way to choose samples and to make pixels of them. One per thread; a tile is a pure function of scene, settings, plan
 * and tile.
 */
public interface TileMethod {
    /** Renders the pixels of a tile. */
    void render(FilmTile tile);
}

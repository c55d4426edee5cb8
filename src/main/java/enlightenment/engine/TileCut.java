package enlightenment.engine;

import enlightenment.scene.RenderSettings;

/** A division of a picture, or of its rendered part, into tiles. */
interface TileCut {
    /** The number of tiles, numbered from 0. */
    int tiles();

    /** The pixels of a tile, by their place in the whole picture. */
    RenderSettings.Crop place(int tile);
}

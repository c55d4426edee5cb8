package enlightenment.engine;

import enlightenment.scene.RenderSettings;

/** How a picture, or the part of it that is rendered, is cut into tiles. */
interface TileCut {
    /** How many there are, numbered from 0. */
    int tiles();

    /** The pixels of a tile, by their place in the whole picture. */
    RenderSettings.Crop place(int tile);
}

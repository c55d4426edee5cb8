package enlightenment.render;

import enlightenment.scene.RenderSettings;

/**
 * How a picture is cut for many machines: columns of 8 pixels, each cut further down where that is wanted. All cuts lie on
 * multiples of 8 of the whole picture, so that a part of it shares its blocks with the whole. Numbered column by column
 * from the left, each from the top.
 */
final class ColumnGrid {
    /** Width of a tile, and what its first row is a multiple of. */
    static final int SIDE = 8;

    /**
     * Where more tiles than these would do no harm they do no good either: a hundred machines get dozens each, and what a
     * tile costs beside its rendering is paid once in several thousand.
     */
    private static final int ENOUGH_TILES = 4096;

    /** A tile of so many rows is half a megabyte. */
    private static final int MOST_ROWS = 2048;

    private final RenderSettings.Crop region;
    private final int firstColumn;
    private final int firstRow;
    private final int rows;
    private final int down;
    private final int tiles;

    ColumnGrid(RenderSettings settings) {
        region = settings.region();
        firstColumn = region.x() / SIDE;
        int across = (region.x() + region.width() - 1) / SIDE - firstColumn + 1;
        int blocksDown = (region.y() + region.height() - 1) / SIDE - region.y() / SIDE + 1;
        firstRow = region.y() / SIDE * SIDE;
        int pieces = Math.max(ENOUGH_TILES / across, 1);
        int blocks = Math.max((blocksDown + pieces - 1) / pieces, 1);
        rows = Math.min(blocks * SIDE, MOST_ROWS);
        down = (blocksDown * SIDE + rows - 1) / rows;
        tiles = Math.multiplyExact(across, down);
    }

    int tiles() {
        return tiles;
    }

    /** The pixels of a tile, by their place in the whole picture. */
    RenderSettings.Crop place(int tile) {
        int left = (firstColumn + tile / down) * SIDE;
        int top = firstRow + tile % down * rows;
        int x = Math.max(left, region.x());
        int y = Math.max(top, region.y());
        int right = Math.min(left + SIDE, region.x() + region.width());
        int bottom = Math.min(top + rows, region.y() + region.height());
        return new RenderSettings.Crop(x, y, right - x, bottom - y);
    }
}

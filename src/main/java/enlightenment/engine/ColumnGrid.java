package enlightenment.engine;

import enlightenment.film.FilmTile;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;

/**
 * How a picture is cut for many machines: into columns one block wide, and these into tiles of whole blocks. All cuts lie between
 * blocks of the whole picture, so that a part of it shares its blocks with the whole. Numbered column by column
 * from the left, each from the top.
 */
final class ColumnGrid implements TileCut {
    /** Width of a tile, and what its first row is a multiple of. */
    private static final int SIDE = FilmTile.BLOCK_SIDE;

    /** At least this many tiles, if there are as many blocks: a hundred machines get dozens each. */
    private static final int FEWEST_TILES = 1 << 12;

    /** A tile of this many rows is half a megabyte. */
    private static final int MOST_ROWS = 2048;

    private final RenderSettings.Crop region;
    private final int firstColumn;
    private final int firstRow;
    private final int rows;
    private final int down;
    private final int tiles;

    ColumnGrid(RenderSettings settings, RenderPlan plan) {
        region = settings.region();
        firstColumn = region.x() / SIDE;
        int across = (region.x() + region.width() - 1) / SIDE - firstColumn + 1;
        int blocksDown = (region.y() + region.height() - 1) / SIDE - region.y() / SIDE + 1;
        firstRow = region.y() / SIDE * SIDE;
        int pieces = Math.max(tilesFor(region, plan) / across, 1);
        int blocks = Math.max((blocksDown + pieces - 1) / pieces, 1);
        rows = Math.min(blocks * SIDE, MOST_ROWS);
        down = (blocksDown * SIDE + rows - 1) / rows;
        tiles = Math.multiplyExact(across, down);
    }

    /** How many tiles to cut; there may be fewer blocks. */
    private static int tilesFor(RenderSettings.Crop region, RenderPlan plan) {
        double rays = (double) region.width() * region.height() * plan.samples();
        return (int) Math.max(FEWEST_TILES, Math.min(WorkUnits.MOST_UNITS, rays / WorkUnits.RAYS_PER_UNIT));
    }

    @Override
    public int tiles() {
        return tiles;
    }

    @Override
    public RenderSettings.Crop place(int tile) {
        int left = (firstColumn + tile / down) * SIDE;
        int top = firstRow + tile % down * rows;
        return region.intersection(new RenderSettings.Crop(left, top, SIDE, rows));
    }
}

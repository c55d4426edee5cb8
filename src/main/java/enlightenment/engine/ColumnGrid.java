package enlightenment.engine;

import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;

/**
 * The tiles of a picture for many machines: columns one block wide are cut into tiles of whole blocks. All cuts lie between blocks of the
 * whole picture, so that a part of it shares its blocks with the whole. Numbered column by column from the left, each from the top.
 */
final class ColumnGrid implements TileCut {
    /** At least this many tiles, if there are as many blocks: a hundred machines get dozens each. */
    private static final int FEWEST_TILES = 1 << 12;

    /** A tile of this many pixels is half a megabyte; of linear light it is larger. */
    private static final int MOST_PIXELS = 1 << 14;

    /** Width of a tile, and what its first row is a multiple of. */
    private final int side;

    private final RenderSettings.Crop region;
    private final int firstColumn;
    private final int firstRow;
    private final int rows;
    private final int down;
    private final int tiles;

    ColumnGrid(RenderSettings settings, RenderPlan plan) {
        region = settings.region();
        side = WorkUnits.blockSide(settings, plan);
        firstColumn = region.x() / side;
        int across = (region.x() + region.width() - 1) / side - firstColumn + 1;
        int blocksDown = (region.y() + region.height() - 1) / side - region.y() / side + 1;
        firstRow = region.y() / side * side;
        int pieces = Math.max(tilesFor(region, plan) / across, 1);
        int blocks = Math.max((blocksDown + pieces - 1) / pieces, 1);
        rows = Math.min(blocks * side, MOST_PIXELS / side);
        down = (blocksDown * side + rows - 1) / rows;
        tiles = Math.multiplyExact(across, down);
    }

    /** The number of tiles to cut; there may be fewer blocks. */
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
        int left = (firstColumn + tile / down) * side;
        int top = firstRow + tile % down * rows;
        return region.intersection(new RenderSettings.Crop(left, top, side, rows));
    }
}

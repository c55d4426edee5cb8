package enlightenment.engine;

import enlightenment.film.FilmTile;
import enlightenment.scene.RenderSettings;
import java.math.BigInteger;

/**
 * The tiles of a picture for the threads of one process. They are the squares of the settings, numbered in the order in which they are
 * rendered.
 */
public final class TileGrid implements TileCut {
    private final RenderSettings.Crop region;
    private final int size;
    private final int across;

    private final int count;

    /** Steps from one tile to the next that is handed out. */
    private final int stride;

    /** The tiles of the part of the picture that is rendered. */
    public TileGrid(RenderSettings settings) {
        this(settings, FilmTile.BLOCK_SIDE);
    }

    /** @param blockSide of {@link enlightenment.plan.MethodTraits}: larger ones are not cut, whatever the settings say */
    public TileGrid(RenderSettings settings, int blockSide) {
        region = settings.region();
        int asked = settings.tileSize();
        size = blockSide == FilmTile.BLOCK_SIDE
                ? asked
                : (int) Math.min(
                        ((long) asked + blockSide - 1) / blockSide * blockSide,
                        Integer.MAX_VALUE / blockSide * blockSide);
        // Tiles are cut from the whole picture's corner, so that a crop shares them with the whole.
        across = (region.x() + region.width() - 1) / size - region.x() / size + 1;
        int down = (region.y() + region.height() - 1) / size - region.y() / size + 1;
        count = Math.multiplyExact(across, down);
        stride = stride(count);
    }

    /**
     * A number without common divisors with {@code tiles}, near the golden section of it: tiles taken in this step are
     * scattered over the picture. So an unfinished picture shows something of everything, and the just-in-time compiler
     * sees the whole scene before it decides what is common (measured: a third less compiling, docs/notes/benchmarks.md).
     */
    static int stride(int tiles) {
        double goldenSection = (Math.sqrt(5) - 1) / 2;
        int step = Math.max((int) (tiles * goldenSection), 1);
        while (!BigInteger.valueOf(step).gcd(BigInteger.valueOf(tiles)).equals(BigInteger.ONE)) {
            step++;
        }
        return step;
    }

    @Override
    public int tiles() {
        return count;
    }

    @Override
    public RenderSettings.Crop place(int tile) {
        int index = (int) ((long) tile * stride % count);
        int left = (region.x() / size + index % across) * size;
        int top = (region.y() / size + index / across) * size;
        return region.intersection(new RenderSettings.Crop(left, top, size, size));
    }
}

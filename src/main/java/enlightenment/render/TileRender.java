package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.Film;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.method.RenderPlan;
import enlightenment.method.TileMethod;
import enlightenment.scene.RenderSettings;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * One render, cut into tiles that are fixed by the picture. Threads take tiles from a counter; each tile is a pure
 * function, so who takes which does not matter.
 */
final class TileRender {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RenderPlan plan;
    private final RenderSettings.Crop region;
    private final RenderProgress progress;
    private final BooleanSupplier cancelled;
    private final Film film;
    private final int tilesAcross;
    private final int tiles;

    /** Steps from one tile to the next that is handed out. */
    private final int stride;

    private final List<RayCounters> counters = new ArrayList<>();
    private long pixelsDone;
    private long peakMemory;

    TileRender(
            CompiledScene scene,
            RenderSettings settings,
            RenderPlan plan,
            RenderProgress progress,
            BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.plan = plan;
        this.progress = progress;
        this.cancelled = cancelled;
        region = settings.region();
        film = new Film(region.x(), region.y(), region.width(), region.height());
        int size = settings.tileSize();
        // Tiles are cut from the whole picture's corner, so that a crop shares them with the whole.
        tilesAcross = (region.x() + region.width() - 1) / size - region.x() / size + 1;
        int tilesDown = (region.y() + region.height() - 1) / size - region.y() / size + 1;
        tiles = Math.multiplyExact(tilesAcross, tilesDown);
        stride = stride(tiles);
    }

    /**
     * A number without common divisors with {@code tiles}, near the golden section of it: tiles taken in this step are
     * scattered over the picture. So an unfinished picture shows something of everything, and the just-in-time compiler
     * sees the whole scene before it decides what is common (measured: a third less compiling, docs/benchmarks.md).
     */
    private static int stride(int tiles) {
        double goldenSection = (Math.sqrt(5) - 1) / 2;
        int step = Math.max((int) (tiles * goldenSection), 1);
        while (!BigInteger.valueOf(step).gcd(BigInteger.valueOf(tiles)).equals(BigInteger.ONE)) {
            step++;
        }
        return step;
    }

    void run() {
        Workers.run(settings.threads(), tiles, cancelled, () -> {
            RayCounters mine = new RayCounters(scene.kindNames.size());
            counters.add(mine);
            TileMethod method = plan.method(scene, settings, mine);
            return index -> renderTile(method, (int) ((long) index * stride % tiles));
        });
    }

    private void renderTile(TileMethod method, int index) {
        TileEvent event = new TileEvent();
        event.begin();
        FilmTile tile = tile(index);
        method.render(tile);
        film.put(tile);
        event.x = tile.x;
        event.y = tile.y;
        event.pixels = tile.width * tile.height;
        event.commit();
        finished(tile);
    }

    private FilmTile tile(int index) {
        int size = settings.tileSize();
        int left = (region.x() / size + index % tilesAcross) * size;
        int top = (region.y() / size + index / tilesAcross) * size;
        int x = Math.max(left, region.x());
        int y = Math.max(top, region.y());
        int width = Math.min(left + size, region.x() + region.width()) - x;
        int height = Math.min(top + size, region.y() + region.height()) - y;
        return new FilmTile(x, y, width, height);
    }

    private synchronized void finished(FilmTile tile) {
        pixelsDone += (long) tile.width * tile.height;
        Runtime runtime = Runtime.getRuntime();
        peakMemory = Math.max(peakMemory, runtime.totalMemory() - runtime.freeMemory());
        progress.progress(pixelsDone, (long) region.width() * region.height(), film::toImage);
    }

    /** What was rendered, in full precision. */
    Film film() {
        return film;
    }

    Image image() {
        return film.toImage();
    }

    boolean isComplete() {
        return pixelsDone == (long) region.width() * region.height();
    }

    RenderReport report(String sceneName, List<RenderReport.Phase> phases) {
        RayCounters all = new RayCounters(scene.kindNames.size());
        for (RayCounters one : counters) {
            all.add(one);
        }
        RenderOutline outline =
                new RenderOutline(sceneName, settings, TilePlan.of(plan), scene.features(), scene.kindNames);
        return Reports.of(outline, film.error(), film.cameraSamples(), all, phases, pixelsDone, peakMemory);
    }
}

package enlightenment.engine;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatSums;
import enlightenment.film.TileGrowth;
import enlightenment.method.SplatIntegrator;
import enlightenment.method.TileIntegrator;
import enlightenment.plan.Integrators;
import enlightenment.plan.Learned;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/** Does units of work, for one thread. */
public final class UnitWork {
    private final WorkUnits units;
    private final DisplayCurve display;

    /** What makes tiles, or null. */
    private final TileIntegrator tiles;

    /** What follows paths, and where they put their light; or null. */
    private final SplatIntegrator paths;

    private final SplatBatch batch;

    /**
     * What does the units.
     *
     * @param units those of the render that is outlined
     * @param counters what it counts is added to these
     * @param learned is shown what the method learns
     * @param cancelled asked now and then; soon after it becomes true a {@link java.util.concurrent.CancellationException} ends what
     *     is under way
     */
    public UnitWork(
            WorkUnits units,
            CompiledScene scene,
            RenderOutline outline,
            RayCounters counters,
            Learned learned,
            BooleanSupplier cancelled) {
        this(units, scene, outline, counters, tilesOf(units, scene, outline, counters, learned), cancelled);
    }

    private static TileIntegrator tilesOf(
            WorkUnits units, CompiledScene scene, RenderOutline outline, RayCounters counters, Learned learned) {
        return units.haveTiles()
                ? (TileIntegrator) Integrators.of(outline.plan(), scene, outline.settings(), counters, learned)
                : null;
    }

    /**
     * What does the units, tiles by something else than the method's own integrator.
     *
     * @param tiles makes them; null if no units are tiles
     */
    public UnitWork(
            WorkUnits units,
            CompiledScene scene,
            RenderOutline outline,
            RayCounters counters,
            TileIntegrator tiles,
            BooleanSupplier cancelled) {
        this.units = units;
        this.tiles = tiles;
        display = outline.display();
        if (tiles != null) {
            tiles.stopWhen(cancelled);
        }
        if (units.batches() > 0) {
            RenderSettings settings = outline.settings();
            paths = Integrators.splats(outline.plan(), scene, settings, counters);
            paths.stopWhen(cancelled);
            RenderSettings.Crop region = settings.region();
            batch = new SplatBatch(region.x(), region.y(), region.width(), region.height(), outline.splatScale());
        } else {
            paths = null;
            batch = null;
        }
    }

    /** A tile, or a pass over it. */
    FilmTile tile(int unit) {
        RenderSettings.Crop place = units.place(unit);
        FilmTile tile = new FilmTile(place.x(), place.y(), place.width(), place.height(), display);
        part(unit, tile);
        return tile;
    }

    /** Makes a part of a unit's tile. */
    void part(int unit, FilmTile part) {
        tiles.render(part, units.pass(unit), units.passes());
    }

    /** How many samples a pixel has, where a tile with some of them can grow; otherwise 0. */
    int samples(int column, int row) {
        return units.passes() > 1 ? 0 : tiles.samples(column, row);
    }

    /** Makes what is missing of a part of a tile. */
    void grow(FilmTile part, TileGrowth growth) {
        tiles.grow(part, growth);
    }

    /** A batch of paths. */
    SplatSums batch(int unit) {
        int number = units.paths(unit);
        batch.begin(number);
        paths.trace(units.firstPath(unit), number, batch);
        return batch.sums();
    }
}

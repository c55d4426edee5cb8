package enlightenment.engine;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.method.TileIntegrator;
import enlightenment.method.cluster.ClusterStatistics;
import enlightenment.plan.Integrators;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Does units of work, for one thread. */
public final class UnitWork {
    private final WorkUnits units;
    private final TileIntegrator integrator;

    /**
     * What does the units.
     *
     * @param units those of settings and plan
     * @param counters what it counts is added to these
     * @param clusters is shown the ray clusters of each block, if the method has any; null for nobody
     * @param cancelled asked now and then; soon after it becomes true a {@link java.util.concurrent.CancellationException} ends what
     *     is under way
     */
    public UnitWork(
            WorkUnits units,
            CompiledScene scene,
            RenderSettings settings,
            RenderPlan plan,
            RayCounters counters,
            Consumer<List<ClusterStatistics>> clusters,
            BooleanSupplier cancelled) {
        this.units = units;
        integrator = Integrators.of(plan, scene, settings, counters, clusters);
        integrator.stopWhen(cancelled);
    }

    /** A tile, or a pass over it. */
    FilmTile tile(int unit) {
        RenderSettings.Crop place = units.place(unit);
        FilmTile tile = new FilmTile(place.x(), place.y(), place.width(), place.height());
        integrator.render(tile, units.pass(unit), units.passes());
        return tile;
    }

    /** Makes a part of a unit's tile. */
    void part(int unit, FilmTile part) {
        integrator.render(part, units.pass(unit), units.passes());
    }
}

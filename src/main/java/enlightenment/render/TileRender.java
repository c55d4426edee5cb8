package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.ErrorEstimate;
import enlightenment.film.Film;
import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.method.TileIntegrator;
import enlightenment.method.cluster.ClusterStatistics;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.TileMethods;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.RayCounts;
import enlightenment.work.Workers;
import java.util.ArrayList;
import java.util.Comparator;
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
    private final TileGrid grid;

    /** What is shown where nothing is finished yet, or null. */
    private final Preview preview;

    private final List<RayCounters> counters = new ArrayList<>();
    /** Gathers ray clusters, or null. */
    private List<RayCluster> clusters;

    private long pixelsDone;
    private long peakMemory;

    /** @param preview what is shown where nothing is finished yet, or null */
    TileRender(
            CompiledScene scene,
            RenderSettings settings,
            RenderPlan plan,
            RenderProgress progress,
            BooleanSupplier cancelled,
            Preview preview) {
        this.scene = scene;
        this.settings = settings;
        this.plan = plan;
        grid = new TileGrid(settings);
        this.preview = preview;
        this.progress = progress;
        this.cancelled = cancelled;
        region = settings.region();
        film = new Film(region.x(), region.y(), region.width(), region.height());
    }

    /** Says before the start that ray clusters are to be gathered. */
    void gatherClusters() {
        clusters = new ArrayList<>();
    }

    void run() {
        Workers.run(settings.threads(), grid.count, cancelled, () -> {
            RayCounters mine = new RayCounters(scene.kindNames.size());
            counters.add(mine);
            TileIntegrator method = TileMethods.of(plan, scene, settings, mine, clusters == null ? null : this::gather);
            method.stopWhen(cancelled);
            return turn -> renderTile(method, grid.tile(turn));
        });
    }

    private void renderTile(TileIntegrator method, FilmTile tile) {
        TileEvent event = new TileEvent();
        event.begin();
        method.render(tile);
        film.put(tile);
        event.x = tile.x;
        event.y = tile.y;
        event.pixels = tile.width * tile.height;
        event.commit();
        finished(tile);
    }

    private synchronized void finished(FilmTile tile) {
        pixelsDone += (long) tile.width * tile.height;
        Runtime runtime = Runtime.getRuntime();
        peakMemory = Math.max(peakMemory, runtime.totalMemory() - runtime.freeMemory());
        if (preview != null) {
            preview.put(tile);
        }
        progress.progress(pixelsDone, (long) region.width() * region.height(), this::image);
    }

    private void gather(List<ClusterStatistics> records) {
        synchronized (clusters) {
            for (ClusterStatistics record : records) {
                clusters.add(RayCluster.of(record, scene.frame));
            }
        }
    }

    /** The ray clusters that were asked for, in an order that does not depend on threads. */
    List<RayCluster> clusters() {
        if (clusters == null) {
            return List.of();
        }
        List<RayCluster> sorted = new ArrayList<>(clusters);
        sorted.sort(Comparator.comparingInt(RayCluster::y)
                .thenComparingInt(RayCluster::x)
                .thenComparingInt(RayCluster::surface)
                .thenComparingInt(RayCluster::light)
                .thenComparingInt(RayCluster::bounces));
        return sorted;
    }

    /** What was rendered, in full precision. */
    Film film() {
        return film;
    }

    /** The picture as it stands: the film, and what the preview shows where that is not finished. */
    Image image() {
        return preview == null || isComplete() ? film.toImage() : preview.image();
    }

    /** How many pixels are not black for want of samples. */
    long shownPixels() {
        return preview == null ? pixelsDone : preview.shownPixels();
    }

    boolean isComplete() {
        return pixelsDone == (long) region.width() * region.height();
    }

    /**
     * What was done.
     *
     * @param rounding the error of rounding the picture to the depth of its file
     * @param round how often the picture was rendered
     */
    RenderReport report(String sceneName, List<Phases.Timing> phases, double rounding, int round) {
        RayCounters all = new RayCounters(scene.kindNames.size());
        for (RayCounters one : counters) {
            all.add(one);
        }
        ErrorEstimate error = film.error();
        RenderReport.Sampling sampling = new RenderReport.Sampling(
                plan.method(),
                plan.decidedBy(),
                plan.samples(),
                film.cameraSamples() / (double) Math.max(pixelsDone, 1),
                error.rmse(),
                error.low(),
                error.high(),
                all.clusters,
                all.proposals,
                all.accepted,
                rounding,
                round);
        return new RenderReport(
                sceneName,
                settings,
                scene.features(),
                RayCounts.raysByKind(all),
                all.lightSamples,
                all.lightSamplesWithoutRay,
                sampling,
                RayCounts.byPrimitive(scene.kindNames, all.tests),
                RayCounts.byPrimitive(scene.kindNames, all.hits),
                all.textureLookups,
                phases.stream()
                        .map(t -> new RenderReport.Phase(t.name(), t.wallSeconds(), t.cpuSeconds()))
                        .toList(),
                pixelsDone,
                peakMemory);
    }
}

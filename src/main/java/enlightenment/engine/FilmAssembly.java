package enlightenment.engine;

import enlightenment.compiled.RayCounters;
import enlightenment.film.ErrorEstimate;
import enlightenment.film.Film;
import enlightenment.image.Image;
import enlightenment.picture.Rounding;
import enlightenment.plan.RenderPlan;
import enlightenment.report.RenderReport;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Phases;
import enlightenment.work.PictureMemory;
import enlightenment.work.RayCounts;
import enlightenment.work.Stopwatch;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Puts tiles together to a picture: in any order, each as often as one likes, also in place of another. For use by several
 * threads at once.
 */
public final class FilmAssembly {
    private final RenderOutline outline;
    private final ColumnGrid grid;
    private final Film film;
    private final Phases phases;
    private final int round;
    private final int kinds;
    private final Stopwatch time = Stopwatch.started();

    /** Per tile: what it counted, null while it is missing. */
    private final RayCounters[] counters;

    private final long[] surveyRays;

    /** Tiles whose samples are differences: asked of those that are there, as one that is gone must leave nothing. */
    private final BitSet differences = new BitSet();

    private int done;
    private long pixels;
    private long peakMemory;

    /** A picture without tiles yet. */
    public FilmAssembly(RenderOutline outline) {
        this(outline, new Phases(), 1);
    }

    FilmAssembly(RenderOutline outline, Phases phases, int round) {
        this.round = round;
        PictureMemory.check(outline.settings(), 0);
        this.outline = outline;
        this.phases = phases;
        grid = new ColumnGrid(outline.settings(), outline.plan());
        kinds = outline.kinds().size();
        RenderSettings.Crop region = outline.settings().region();
        film = new Film(region.x(), region.y(), region.width(), region.height());
        counters = new RayCounters[grid.tiles()];
        surveyRays = new long[grid.tiles()];
    }

    /** Number of tiles, counted from 0. */
    public int tiles() {
        return counters.length;
    }

    /** Number of bytes of a tile. */
    public int length(int tile) {
        RenderSettings.Crop place = grid.place(Objects.checkIndex(tile, tiles()));
        return TileBytes.length(place.width() * place.height(), kinds);
    }

    /** Why these bytes cannot be this tile: wrong size, what is no number or out of range; empty if they can. */
    public Optional<String> problem(int tile, byte[] bytes) {
        if (tile < 0 || tile >= tiles()) {
            return Optional.of("there is no tile " + tile + "; they are 0.." + (tiles() - 1));
        }
        return TileBytes.problem(bytes, grid.place(tile), kinds);
    }

    /**
     * Puts a tile, in place of what is there of it.
     *
     * @throws IllegalArgumentException if {@link #problem} has something to say
     */
    public void put(int tile, byte[] bytes) {
        problem(tile, bytes).ifPresent(reason -> {
            throw new IllegalArgumentException("tile " + tile + ": " + reason);
        });
        RayCounters mine = TileBytes.counters(bytes, kinds);
        RenderSettings.Crop place = grid.place(tile);
        synchronized (this) {
            TileBytes.into(film, bytes, place, kinds);
            if (counters[tile] == null) {
                done++;
                pixels += (long) place.width() * place.height();
            }
            counters[tile] = mine;
            surveyRays[tile] = TileBytes.surveyRays(bytes);
            differences.set(tile, TileBytes.samplesAreDifferences(bytes, kinds));
            Runtime runtime = Runtime.getRuntime();
            peakMemory = Math.max(peakMemory, runtime.totalMemory() - runtime.freeMemory());
        }
    }

    /** Takes a tile out again; nothing if it is not there. */
    public synchronized void remove(int tile) {
        if (counters[Objects.checkIndex(tile, tiles())] != null) {
            RenderSettings.Crop place = grid.place(tile);
            TileBytes.into(film, null, place, kinds);
            counters[tile] = null;
            surveyRays[tile] = 0;
            differences.clear(tile);
            done--;
            pixels -= (long) place.width() * place.height();
        }
    }

    /** Whether a tile is there. */
    public synchronized boolean has(int tile) {
        return counters[tile] != null;
    }

    /** Number of tiles that are there. */
    public synchronized int done() {
        return done;
    }

    /** Number of pixels that are there. */
    public synchronized long pixelsDone() {
        return pixels;
    }

    /** Number of pixels in all. */
    public long pixels() {
        RenderSettings.Crop region = outline.settings().region();
        return (long) region.width() * region.height();
    }

    private RenderReport report(Image image, RayCounters all, long samples) {
        ErrorEstimate error = film.error();
        RenderPlan plan = outline.plan();
        return new RenderReport(
                outline.sceneName(),
                outline.settings(),
                outline.features(),
                RayCounts.raysByKind(all),
                all.lightSamples,
                all.lightSamplesWithoutRay,
                new RenderReport.Sampling(
                        plan.method(),
                        plan.decidedBy(),
                        plan.samples(),
                        samples / (double) Math.max(pixels, 1),
                        error.rmse(),
                        error.low(),
                        error.high(),
                        all.clusters,
                        all.proposals,
                        all.accepted,
                        Rounding.of(image, outline.settings().budget().depth()),
                        round),
                RayCounts.byPrimitive(outline.kinds(), all.tests),
                RayCounts.byPrimitive(outline.kinds(), all.hits),
                all.textureLookups,
                phases.list().stream()
                        .map(t -> new RenderReport.Phase(t.name(), t.wallSeconds(), t.cpuSeconds()))
                        .toList(),
                pixels,
                peakMemory);
    }

    /** The picture so far; what is missing is black. */
    public synchronized Image image() {
        return film.toImage();
    }

    /** The picture so far with its report, whose phase of rendering began with this assembly. */
    public synchronized RenderResult result() {
        phases.add("render", time.seconds());
        Image image = phases.run("finish", film::toImage);
        RayCounters all = new RayCounters(kinds);
        for (RayCounters one : counters) {
            if (one != null) {
                all.add(one);
            }
        }
        film.samplesAreDifferences(!differences.isEmpty());
        long samples = film.cameraSamples() + Arrays.stream(surveyRays).sum();
        return new RenderResult(
                image, report(image, all, samples), done == counters.length, pixels, Map.of(), List.of());
    }
}

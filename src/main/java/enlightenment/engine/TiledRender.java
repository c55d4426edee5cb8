package enlightenment.engine;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SceneCompiler;
import enlightenment.film.FilmTile;
import enlightenment.method.TileIntegrator;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.plan.TileMethods;
import enlightenment.render.RenderReport;
import enlightenment.render.RenderResult;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Cancellation;
import enlightenment.work.Phases;
import enlightenment.work.PictureMemory;
import enlightenment.work.Stopwatch;
import enlightenment.work.Workers;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * One render as numbered tiles that may be made anywhere, by anyone, in any order: the ground of server, workers and job
 * arrays. {@link FilmAssembly} puts the tiles together to the picture that {@link enlightenment.render.Renderer} makes, bit for bit.
 */
public final class TiledRender {
    private final CompiledScene compiled;
    private final RenderSettings settings;
    private final RenderPlan plan;
    private final ColumnGrid grid;
    private final RenderOutline outline;
    private final Phases phases;

    /** What makes further plans, or null where it was planned elsewhere. */
    private final Planner planner;

    private final Rounds rounds;
    private final int round;
    /** Since it was asked for. */
    private final Stopwatch time;

    private TiledRender(
            String name,
            CompiledScene compiled,
            RenderSettings settings,
            RenderPlan plan,
            Phases phases,
            Planner planner,
            Rounds rounds,
            int round,
            Stopwatch time) {
        this.compiled = compiled;
        this.settings = settings;
        this.plan = plan;
        this.phases = phases;
        this.planner = planner;
        this.rounds = rounds;
        this.round = round;
        this.time = time;
        grid = new ColumnGrid(settings, plan);
        outline = new RenderOutline(name, settings, plan, compiled.features(), compiled.kindNames);
    }

    /**
     * Compiles the scene and plans the render.
     *
     * @param cancelled asked from several threads at once; once true, or once the calling thread is interrupted, a plan is
     *     made in haste
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     */
    public static TiledRender prepare(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        Stopwatch time = Stopwatch.started();
        PictureMemory.check(settings, 0);
        Phases phases = new Phases();
        CompiledScene compiled = phases.run("compile", () -> SceneCompiler.compile(scene, settings));
        Planner planner = new Planner(compiled, settings, Cancellation.of(cancelled));
        RenderPlan plan = phases.run("plan", () -> planner.plan(time, 0));
        Rounds rounds = new Rounds(settings.budget());
        return new TiledRender(scene.name(), compiled, settings, plan, phases, planner, rounds, 1, time);
    }

    /** What cannot be kept of the budget, or only at a price, in plain words. */
    public List<String> notes() {
        return planner == null ? List.of() : planner.notes();
    }

    /**
     * The render that must follow: the same with more samples, if the picture of this one is complete, is not as exact as its
     * budget asks, and the budget allows more. To be asked once; what follows can be asked in turn.
     *
     * @param result what {@link FilmAssembly#result} gave
     * @param log hears why there is another one
     */
    public Optional<TiledRender> next(RenderResult result, Consumer<String> log) {
        if (planner == null || !result.complete()) {
            return Optional.empty();
        }
        RenderReport report = result.report();
        double took = report.phases().stream()
                .filter(p -> p.name().equals("render"))
                .mapToDouble(RenderReport.Phase::wallSeconds)
                .sum();
        RenderReport.Sampling sampling = report.sampling();
        Rounds.Outcome outcome = new Rounds.Outcome(
                settings.method(),
                sampling.method(),
                sampling.plannedSamples(),
                sampling.errorHigh(),
                sampling.rounding());
        OptionalDouble samples = rounds.next(outcome, took, time.seconds());
        if (samples.isEmpty()) {
            return Optional.empty();
        }
        double n = samples.getAsDouble();
        log.accept(rounds.note(outcome, n));
        Phases further = phases.copy();
        further.again();
        RenderPlan more = further.run("plan", () -> planner.withSamples(n, rounds.decidedBy(n)));
        return Optional.of(new TiledRender(
                outline.sceneName(), compiled, settings, more, further, planner, rounds, round + 1, time));
    }

    /** Which render of the picture this is: 1, or more where those before were not as exact as asked. */
    public int round() {
        return round;
    }

    /**
     * A render that was planned elsewhere.
     *
     * @param files gives the content of an image file, or null if it is to be read from the disk
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     */
    public static TiledRender planned(
            Scene scene, RenderSettings settings, RenderPlan plan, Function<Path, byte[]> files) {
        Phases phases = new Phases();
        CompiledScene compiled = phases.run("compile", () -> SceneCompiler.compile(scene, settings, files));
        return new TiledRender(
                scene.name(),
                compiled,
                settings,
                plan,
                phases,
                null,
                new Rounds(settings.budget()),
                1,
                Stopwatch.started());
    }

    /** Number of tiles, counted from 0. */
    public int tiles() {
        return grid.tiles();
    }

    /** What was decided before the first tile. */
    public RenderPlan plan() {
        return plan;
    }

    /** What is needed to put the picture together. */
    public RenderOutline outline() {
        return outline;
    }

    /** A picture without tiles yet. */
    public FilmAssembly assembly() {
        return new FilmAssembly(outline, phases, round);
    }

    /** Makes tiles, for one thread. */
    public TileMaker maker() {
        return maker(() -> false);
    }

    /**
     * The same, unless it is cancelled.
     *
     * @param cancelled asked now and then by that thread; soon after it becomes true {@link TileMaker#make} throws a {@link
     *     java.util.concurrent.CancellationException}, in the middle of a tile if need be
     */
    public TileMaker maker(BooleanSupplier cancelled) {
        RayCounters counters = new RayCounters(compiled.kindNames.size());
        TileIntegrator method = TileMethods.of(plan, compiled, settings, counters);
        method.stopWhen(cancelled);
        return tile -> make(Objects.checkIndex(tile, grid.tiles()), method, counters);
    }

    /** Hears of finished tiles, from several threads at once. */
    @FunctionalInterface
    public interface TileSink {
        /** The tile is made. */
        void made(int tile, byte[] bytes);
    }

    /**
     * Makes some tiles with as many threads as the settings say.
     *
     * @param cancelled asked from several threads at once; once true, or once the calling thread is interrupted, the rest is
     *     left undone
     */
    public void make(int[] tiles, BooleanSupplier cancelled, TileSink sink) {
        BooleanSupplier stop = Cancellation.of(cancelled);
        Workers.run(settings.threads(), tiles.length, stop, () -> {
            TileMaker maker = maker(stop);
            return i -> sink.made(tiles[i], maker.make(tiles[i]));
        });
    }

    private byte[] make(int tile, TileIntegrator method, RayCounters counters) {
        counters.clear();
        RenderSettings.Crop place = grid.place(tile);
        int kinds = compiled.kindNames.size();
        ByteBuffer out = ByteBuffer.allocate(TileBytes.length(place.width() * place.height(), kinds));
        long surveyRays = 0;
        boolean differences = false;
        int side = FilmTile.BLOCK_SIDE;
        int bottom = place.y() + place.height();
        for (int y = place.y(); y < bottom; y = Math.min((y / side + 1) * side, bottom)) {
            int height = Math.min((y / side + 1) * side, bottom) - y;
            FilmTile block = new FilmTile(place.x(), y, place.width(), height);
            method.render(block);
            surveyRays += block.surveyRays();
            differences |= block.hasKnown();
            TileBytes.putBlock(out, kinds, place, block);
        }
        TileBytes.putHeader(out.position(0), counters, surveyRays, differences);
        return out.array();
    }
}

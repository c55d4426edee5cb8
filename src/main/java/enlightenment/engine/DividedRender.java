package enlightenment.engine;

import enlightenment.device.share.DeviceShare;
import enlightenment.device.share.DeviceTiles;
import enlightenment.device.share.PreparedDevice;
import enlightenment.film.SampleLog;
import enlightenment.plan.MethodDecision;
import enlightenment.plan.MethodPilot;
import enlightenment.plan.Planner;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.Rounds;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.work.Cancellation;
import enlightenment.work.Phases;
import enlightenment.work.PictureMemory;
import enlightenment.work.Stopwatch;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * One render as units of work that may be done anywhere, by anyone, in any order: the ground of server, workers and job
 * arrays. {@link FilmAssembly} puts the results together to the picture that {@code enlightenment.render.Renderer} makes, bit for bit.
 */
public final class DividedRender implements UnitSource {
    /** The preview itself, and it with finished pixels over it. */
    private static final int IMAGES_OF_PREVIEW = 2;

    private final CompiledScene compiled;
    private final RenderOutline outline;
    private final WorkUnits units;
    private final UnitMakers makers;

    /** What makes further plans, or null where it was planned elsewhere. */
    private final Planner planner;

    private final RenderCourse course;
    private final FilmRoom room;

    DividedRender(
            CompiledScene compiled,
            RenderOutline outline,
            Phases phases,
            Planner planner,
            Rounds rounds,
            int round,
            Stopwatch time,
            FilmRoom room) {
        this.compiled = compiled;
        this.planner = planner;
        this.outline = outline;
        units = WorkUnits.forMachines(outline.settings(), outline.plan());
        makers = new UnitMakers(units, compiled, outline, ResultForm.of(units, outline));
        course = new RenderCourse(outline, phases, rounds, round, time, room);
        this.room = room;
    }

    /**
     * Compiles the scene and plans the render.
     *
     * @param cancelled asked from several threads at once while it is planned
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     * @throws java.util.concurrent.CancellationException if it is cancelled, or the calling thread interrupted, before it is planned
     */
    public static DividedRender prepare(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        return prepare(scene, settings, new SharedImages(), FilmRoom.MEMORY, cancelled);
    }

    /**
     * Compiles one of several scenes that share image files, and plans the render.
     *
     * @param images provides image files
     * @param room where finished pixels may be
     */
    public static DividedRender prepare(
            Scene scene, RenderSettings settings, SharedImages images, FilmRoom room, BooleanSupplier cancelled) {
        return prepare(scene, settings, images, Optional.of(room), cancelled, false);
    }

    /**
     * Compiles the scene and plans a render whose {@link #next} is never called: its plan alone keeps a requested error.
     *
     * @param room where finished pixels may be
     * @throws enlightenment.math.InvalidValueException also if an error is all that limits a method that has no trials for it
     */
    public static DividedRender prepareOnce(
            Scene scene, RenderSettings settings, FilmRoom room, BooleanSupplier cancelled) {
        return prepare(scene, settings, new SharedImages(), Optional.of(room), cancelled, true);
    }

    /** {@link #prepareOnce} for a render of which only some units are made here, and no picture. */
    public static DividedRender preparePart(Scene scene, RenderSettings settings, BooleanSupplier cancelled) {
        return prepare(scene, settings, new SharedImages(), Optional.empty(), cancelled, true);
    }

    private static DividedRender prepare(
            Scene scene,
            RenderSettings asked,
            SharedImages images,
            Optional<FilmRoom> room,
            BooleanSupplier cancelled,
            boolean isLast) {
        Stopwatch time = Stopwatch.started();
        // Before what takes long; AUTO takes no method whose pictures must be in memory where this one need not be.
        room.ifPresent(r -> r.check(
                PictureMemory.of(scene, asked, PictureMemory.Films.TILES, 0), FilmRoom.wholeInMemory(asked.method())));
        Phases phases = new Phases();
        BooleanSupplier stopped = Cancellation.of(cancelled);
        CompiledScene compiled =
                phases.run("compile", () -> SceneCompiler.compile(scene, asked, images.images, stopped));
        Optional<MethodDecision> choice = asked.method() == Method.AUTO
                ? Optional.of(phases.run("pilot", () -> MethodPilot.decide(scene, compiled, asked, stopped)))
                : Optional.empty();
        RenderSettings settings = choice.map(c -> asked.withMethod(c.method())).orElse(asked);
        Planner planner = new Planner(compiled, settings, stopped);
        choice.ifPresent(c -> planner.note(c.reason()));
        RenderPlan plan = phases.run("plan", () -> isLast ? planner.planOnce(time) : planner.plan(time, 0));
        Rounds rounds = new Rounds(settings.budget());
        RenderOutline outline = RenderOutline.of(scene.name(), compiled, settings, plan);
        room.ifPresent(r -> FilmAssembly.check(outline, r));
        return new DividedRender(compiled, outline, phases, planner, rounds, 1, time, room.orElse(FilmRoom.MEMORY));
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
     * @throws java.util.concurrent.CancellationException if it is cancelled before that one is planned
     */
    public Optional<DividedRender> next(Rendered result, Consumer<String> log) {
        if (planner == null) {
            return Optional.empty();
        }
        OptionalDouble samples = course.next(result, log);
        return samples.isPresent()
                ? Optional.of(course.again(compiled, planner, samples.getAsDouble()))
                : Optional.empty();
    }

    /** Which render of the picture this is: 1, or more where those before were not as exact as asked. */
    public int round() {
        return course.round();
    }

    /** What can be kept of this render without its scene. */
    public RenderCourse course() {
        return course;
    }

    /**
     * A render that was planned elsewhere, to make its units.
     *
     * @param files gives the content of an image file, or null if it is to be read from the disk
     * @throws enlightenment.scene.SceneException if the scene cannot be used
     * @throws enlightenment.math.InvalidValueException if a setting cannot be used
     */
    public static DividedRender planned(
            Scene scene, RenderSettings settings, RenderPlan plan, Function<Path, byte[]> files) {
        return planned(scene, settings, plan, new SharedImages(files));
    }

    /**
     * A render of one of several scenes that share image files, planned elsewhere, to make its units.
     *
     * @param images provides image files
     */
    public static DividedRender planned(Scene scene, RenderSettings settings, RenderPlan plan, SharedImages images) {
        Phases phases = new Phases();
        CompiledScene compiled = phases.run("compile", () -> SceneCompiler.compile(scene, settings, images.images));
        return alone(compiled, RenderOutline.of(scene.name(), compiled, settings, plan), phases);
    }

    /** The units of a render whose scene is compiled, and which is planned. */
    public static DividedRender of(String name, CompiledScene compiled, RenderSettings settings, RenderPlan plan) {
        return alone(compiled, RenderOutline.of(name, compiled, settings, plan), new Phases());
    }

    /** A render that no other follows. */
    private static DividedRender alone(CompiledScene compiled, RenderOutline outline, Phases phases) {
        Rounds rounds = new Rounds(outline.settings().budget());
        return new DividedRender(compiled, outline, phases, null, rounds, 1, Stopwatch.started(), FilmRoom.MEMORY);
    }

    @Override
    public int units() {
        return units.count();
    }

    /**
     * The whole picture with the fewest samples that show it, which takes a moment, on as many threads as the settings say.
     *
     * @return empty if there is too little memory for it, or paths may end anywhere: they show something of the whole picture themselves
     */
    public Optional<Preview> preview(BooleanSupplier cancelled) {
        if (!units.haveTiles()
                || room.isExceededBy(units.memory(outline, 0))
                || !units.memory(outline, IMAGES_OF_PREVIEW).isEnough()) {
            return Optional.empty();
        }
        Preview preview = new Preview(Preview.Kind.COARSE, compiled, outline.settings());
        preview.begin(Cancellation.of(cancelled));
        return Optional.of(preview);
    }

    /** What was decided before the first unit. */
    public RenderPlan plan() {
        return outline.plan();
    }

    /** What is needed to put the picture together. */
    public RenderOutline outline() {
        return outline;
    }

    /** A picture of which nothing is there yet. */
    public FilmAssembly assembly() {
        return assembly(true);
    }

    /**
     * A picture of which nothing is there yet.
     *
     * @param canLose whether units may have to be taken out again, which takes more memory
     */
    public FilmAssembly assembly(boolean canLose) {
        return course.assembly(canLose);
    }

    /** A picture of which nothing is there yet, whose units are not taken out again, with finished pixels in this place. */
    public FilmAssembly assembly(FilmPlace place) {
        return course.assembly(place);
    }

    /** Does units, for one thread. */
    public UnitMaker maker() {
        return maker(() -> false);
    }

    @Override
    public UnitMaker maker(BooleanSupplier cancelled) {
        return makers.maker(cancelled);
    }

    @Override
    public UnitMaker maker(DeviceShare device, BooleanSupplier cancelled) {
        return device.tryPrepare(compiled, outline.settings())
                .map(tiles -> makers.maker(tiles, cancelled))
                .orElseGet(() -> makers.maker(cancelled));
    }

    /** Whether more samples can be added to the results of tiles: the method lets them, and the tiles are made in one pass. */
    public boolean canGrow() {
        return units.passes() == 1 && methodCanGrow();
    }

    /** Whether the method has tiles, and lets more samples be added to their results. */
    public boolean methodCanGrow() {
        return makers.methodCanGrow();
    }

    /**
     * Does units, for one thread, so that more samples can be added to them later.
     *
     * @param cancelled as for {@link #maker(BooleanSupplier)}
     * @param log receives the camera samples of each unit: all of them where it goes on from nothing; null for none
     */
    public GrowingMaker growing(BooleanSupplier cancelled, SampleLog log) {
        return makers.growing(cancelled, log);
    }

    /**
     * Does units by a device, for one thread, so that more samples can be added to them later.
     *
     * @param tiles of this render's scene; not closed
     */
    public GrowingMaker growing(DeviceTiles tiles, BooleanSupplier cancelled) {
        return makers.growing(tiles, cancelled);
    }

    /**
     * Copies the scene to the device that was asked for.
     *
     * @param notes receives messages for the user
     * @throws enlightenment.math.InvalidValueException key {@code device}, if the device that was asked for by name cannot take part
     */
    public PreparedDevice prepare(String device, Consumer<String> notes) {
        return PreparedDevice.of(device, compiled, outline.settings(), notes);
    }

    /** Receives the results of units that are done, from several threads at once. */
    @FunctionalInterface
    public interface ResultSink {
        /** The unit is done. */
        void made(int unit, byte[] bytes);
    }

    /**
     * Does some units with as many threads as the settings say, and some more for a device.
     *
     * @param device a thread each; not closed
     * @param cancelled asked from several threads at once; once true, or once the calling thread is interrupted, the rest is
     *     left undone
     */
    public void make(int[] some, List<DeviceTiles> device, BooleanSupplier cancelled, ResultSink sink) {
        BooleanSupplier stop = Cancellation.of(cancelled);
        Iterator<DeviceTiles> tiles = device.iterator();
        Workers.run(outline.settings().threads() + device.size(), some.length, stop, () -> {
            // Closed by their owner.
            @SuppressWarnings("resource")
            UnitMaker maker = tiles.hasNext() ? makers.maker(tiles.next(), stop) : maker(stop);
            return i -> sink.made(some[i], maker.make(some[i]));
        });
    }
}

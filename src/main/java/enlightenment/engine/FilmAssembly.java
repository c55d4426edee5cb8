package enlightenment.engine;

import enlightenment.file.ContentHash;
import enlightenment.image.Image;
import enlightenment.picture.Rounding;
import enlightenment.report.RenderReport;
import enlightenment.work.Phases;
import enlightenment.work.Stopwatch;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Puts results of units together to a picture: in any order, each as often as one likes, also in place of another. For use by
 * several threads at once.
 */
public final class FilmAssembly implements UnitAssembly {
    private final RenderOutline outline;
    private final WorkUnits units;
    private final ResultForm form;
    private final PictureFilm film;
    private final Phases phases;
    private final int round;
    private final Stopwatch time = Stopwatch.started();

    /** Per unit: what it counted, null while it is missing. */
    private final RayCounters[] counters;

    private final long[] surveyRays;

    /** Per unit: samples that were no finite numbers. */
    private final long[] lost;

    /** Units whose samples are differences: asked of those that are there, as one that is gone must leave nothing. */
    private final BitSet differences = new BitSet();

    private ResultStore store = ResultStore.NONE;

    /** The picture to show where no unit is finished yet; null for none. */
    private Preview preview;

    private long peakMemory;

    /**
     * A picture of which nothing is there yet, whose units are not taken out again.
     *
     * @param room where finished pixels may be
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space on the disk
     */
    public FilmAssembly(RenderOutline outline, FilmRoom room) {
        this(outline, new Phases(), 1, false, place(outline, room));
    }

    /**
     * A picture of which nothing is there yet.
     *
     * @param canLose whether units may have to be taken out again
     * @param place where the finished pixels are
     */
    FilmAssembly(RenderOutline outline, Phases phases, int round, boolean canLose, FilmPlace place) {
        this.round = round;
        this.outline = outline;
        this.phases = phases;
        units = WorkUnits.forMachines(outline.settings(), outline.plan());
        if (place.folder().isEmpty()) {
            units.memory(outline, 0).check();
        }
        form = ResultForm.of(units, outline);
        film = PictureFilm.of(units, outline, canLose, place);
        counters = new RayCounters[units.count()];
        surveyRays = new long[units.count()];
        lost = new long[units.count()];
    }

    /**
     * The place of a picture's finished pixels, where units come in any order.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space on the disk
     */
    static FilmPlace place(RenderOutline outline, FilmRoom room) {
        WorkUnits units = WorkUnits.forMachines(outline.settings(), outline.plan());
        return room.place(units.memory(outline, 0), units.wholeInMemory(outline.plan()));
    }

    /**
     * Checks that there is a {@link #place} for such pictures, before anything is rendered.
     *
     * @throws enlightenment.math.InvalidValueException if there is too little memory, or too little space on the disk
     */
    static void check(RenderOutline outline, FilmRoom room) {
        WorkUnits units = WorkUnits.forMachines(outline.settings(), outline.plan());
        room.check(units.memory(outline, 0), units.wholeInMemory(outline.plan()));
    }

    @Override
    public boolean needsStore() {
        return form.needsStore();
    }

    @Override
    public void keepIn(ResultStore results) {
        store = results;
    }

    @Override
    public int units() {
        return units.count();
    }

    @Override
    public int longest(int unit) {
        return form.longest(Objects.checkIndex(unit, units()));
    }

    @Override
    public Optional<String> problem(int unit, byte[] bytes) {
        return form.problemOf(unit, bytes, false);
    }

    @Override
    public ContentHash digest(int unit, byte[] bytes) {
        return form.digest(bytes);
    }

    /** As {@link #problem}, of a result that was kept with what it can grow by ({@link GrowingMaker}). */
    public Optional<String> problemOfKept(int unit, byte[] bytes) {
        return form.problemOf(unit, bytes, true);
    }

    @Override
    public void put(int unit, byte[] bytes) {
        problemOfKept(unit, bytes).ifPresent(reason -> {
            throw new IllegalArgumentException("unit " + unit + ": " + reason);
        });
        int kinds = outline.kinds().size();
        RayCounters mine = ResultHeader.counters(bytes, kinds);
        synchronized (this) {
            remove(unit);
            form.put(film, unit, bytes);
            if (form.needsStore()) {
                store.keep(unit, bytes);
            }
            counters[unit] = mine;
            surveyRays[unit] = ResultHeader.surveyRays(bytes);
            lost[unit] = ResultHeader.lostSamples(bytes, kinds);
            differences.set(unit, ResultHeader.samplesAreDifferences(bytes, kinds));
            Runtime runtime = Runtime.getRuntime();
            peakMemory = Math.max(peakMemory, runtime.totalMemory() - runtime.freeMemory());
        }
    }

    @Override
    public synchronized void remove(int unit) {
        if (film.has(Objects.checkIndex(unit, units()))) {
            form.remove(film, unit, store);
            counters[unit] = null;
            surveyRays[unit] = 0;
            lost[unit] = 0;
            differences.clear(unit);
        }
    }

    /** The number of camera rays in the result of a unit. */
    public static long cameraRays(byte[] bytes) {
        return ResultHeader.cameraRays(bytes);
    }

    @Override
    public boolean has(int unit) {
        return film.has(unit);
    }

    @Override
    public int done() {
        return film.done();
    }

    /**
     * The missing units, in an order that suits the threads of one process. Batches come first, then tiles scattered over the picture, for
     * the reasons of {@link TileGrid}.
     */
    public int[] missing() {
        int batches = units.batches();
        int passes = units.passes();
        int tiles = (units.count() - batches) / passes;
        int stride = tiles == 0 ? 0 : TileGrid.stride(tiles);
        IntStream scattered = IntStream.range(0, tiles).flatMap(i -> {
            int first = batches + (int) ((long) i * stride % tiles) * passes;
            return IntStream.range(first, first + passes);
        });
        return IntStream.concat(IntStream.range(0, batches), scattered)
                .filter(unit -> !has(unit))
                .toArray();
    }

    @Override
    public long pixelsDone() {
        return film.pixelsDone();
    }

    @Override
    public long pixels() {
        return film.pixels();
    }

    /** The picture in the making. */
    public PictureFilm film() {
        return film;
    }

    /**
     * Sets the picture that {@link #image} shows where no unit is finished yet.
     *
     * @param coarse null for black
     */
    public synchronized void showBeneath(Preview coarse) {
        preview = coarse;
    }

    @Override
    public synchronized Image image() {
        Image image = film.shown();
        return preview == null || film.isComplete() ? image : preview.beneath(film, image);
    }

    /** The picture so far with its report, whose phase of rendering began with this assembly. */
    public synchronized Rendered result() {
        phases.add("render", time.seconds());
        Image image = phases.run("finish", this::finished);
        double rounding = Rounding.of(image, outline.settings().budget().depth());
        return new Rendered(image, report(phases, rounding, round), film.isComplete(), film.shownPixels());
    }

    /** The picture so far, which knows what its samples are. */
    public synchronized Image finished() {
        film.samplesAreDifferences(!differences.isEmpty());
        film.samplesAreLost(Arrays.stream(lost).sum());
        return film.image();
    }

    /**
     * The report of the render.
     *
     * @param took the times of the render's phases
     * @param rounding the error of rounding the picture to the depth of its file
     * @param number which round of the render it is
     */
    public synchronized RenderReport report(Phases took, double rounding, int number) {
        RayCounters all = new RayCounters(outline.kinds().size());
        for (RayCounters one : counters) {
            if (one != null) {
                all.add(one);
            }
        }
        return Reports.of(outline, film, all, Arrays.stream(surveyRays).sum(), took, rounding, number, peakMemory);
    }
}

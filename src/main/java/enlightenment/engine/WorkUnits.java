package enlightenment.engine;

import enlightenment.check.Check;
import enlightenment.color.Color;
import enlightenment.film.FilmTile;
import enlightenment.plan.Integrators;
import enlightenment.plan.MethodTraits;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import enlightenment.work.PictureMemory;
import java.util.Objects;
import java.util.Optional;

/**
 * The units of work of a render, numbered from 0: each is a pure function of compiled scene, settings, plan and its number, and may
 * be done by anybody, at any time, more than once. A unit is a tile of the picture or, where its pixels have very many samples, one of
 * several passes over a tile, which takes a part of them; or, where light may fall anywhere, a batch of paths. A render may have units
 * of both kinds: what the paths bring is added to what the tiles make.
 *
 * <p>Batches come first: so a picture that is stopped has all of them, and no thread is left with a long one in the end. All passes of
 * a tile have consecutive numbers. How many passes, batches and paths there are depends on plan and whole picture alone; how the tiles
 * are cut has no influence on the picture.
 */
public final class WorkUnits {
    /**
     * The camera rays of a unit: half a second of one processor or more. With shorter units a server could not serve a thousand workers,
     * with longer ones workers would wait for each other.
     */
    static final double RAYS_PER_UNIT = 1 << 21;

    /** More units than these cost the server more than they give. */
    static final int MOST_UNITS = 1 << 18;

    /** Passes come in powers of two: with this, units are worth from two thirds to four thirds of what they should. */
    private static final double NEAREST = 1.5;

    /** With fewer passes the quarters of the samples, which tell the error, could not be kept apart. */
    private static final int FEWEST_PASSES = 4;

    private static final int SAMPLES_PER_PASS = 16;

    /** Up to this many large blocks their quarters are units, so that all processors have work. */
    private static final int FEW_LARGE_BLOCKS = 1 << 10;

    /** Paths of a batch; twice, four times, ... as many where there would be too many batches. */
    private static final int PATHS_PER_BATCH = 1 << 16;

    /** The batches form this many groups, whose differences give the error: beside tiles all groups have equally many paths. */
    private static final int GROUPS = 4;

    /** A batch has at most 2^30 paths, a job at most 2^24 units; this many paths take a million processors a day. */
    private static final double MOST_PATHS = 1L << 52;

    /** The quarters of a tile have six doubles and an int per pixel each, an image has three floats. */
    private static final int IMAGES_OF_PASSES = 4 * (6 * 8 + 4) / (3 * 4);

    /** Null if there are none. */
    private final TileCut cut;

    private final int passes;
    private final long paths;
    private final int pathsPerBatch;
    private final int batches;
    private final int count;
    private final int blockSide;

    private WorkUnits(RenderSettings settings, RenderPlan plan, TileCut cut) {
        blockSide = blockSide(settings, plan);
        this.cut = cut;
        if (cut == null) {
            passes = 1;
            paths = paths(settings, plan);
            pathsPerBatch = pathsPerBatch(paths);
            batches = Math.toIntExact((paths + pathsPerBatch - 1) / pathsPerBatch);
            count = batches;
            return;
        }
        passes = passes(settings, plan);
        long wanted = plan.lightPaths();
        long inGroups = (long) GROUPS * pathsPerBatch(wanted);
        batches = Math.toIntExact((wanted + inGroups - 1) / inGroups * GROUPS);
        pathsPerBatch = batches == 0 ? 0 : (int) ((wanted + batches - 1) / batches);
        paths = (long) batches * pathsPerBatch;
        count = Math.addExact(batches, Math.multiplyExact(cut.tiles(), passes));
    }

    /** As they are handed out to the threads of one process. */
    public static WorkUnits forThreads(RenderSettings settings, RenderPlan plan) {
        MethodTraits traits = traits(settings, plan);
        return new WorkUnits(settings, plan, traits.areBatches() ? null : new TileGrid(settings, traits.blockSide()));
    }

    /** As they are handed out to many machines. */
    public static WorkUnits forMachines(RenderSettings settings, RenderPlan plan) {
        return new WorkUnits(
                settings, plan, traits(settings, plan).areBatches() ? null : new ColumnGrid(settings, plan));
    }

    /** Side of the blocks that tiles are not cut through. */
    static int blockSide(RenderSettings settings, RenderPlan plan) {
        return traits(settings, plan).blockSide();
    }

    private static MethodTraits traits(RenderSettings settings, RenderPlan plan) {
        return Integrators.traits(plan.method(), settings);
    }

    /**
     * In how many passes each tile is made: 1, or a power of two from 4 on. More than one only where a single block of pixels takes
     * longer than a unit should.
     */
    static int passes(RenderSettings settings, RenderPlan plan) {
        MethodTraits traits = traits(settings, plan);
        int side = traits.blockSide();
        long blocks = (settings.width() + side - 1L) / side * ((settings.height() + side - 1L) / side);
        if (side > FilmTile.BLOCK_SIDE) {
            return traits.dividesIntoPasses() && blocks <= FEW_LARGE_BLOCKS ? FEWEST_PASSES : 1;
        }
        double most = Math.min(
                Math.min(NEAREST * side * side * plan.samples() / RAYS_PER_UNIT, (double) MOST_UNITS / blocks),
                // Pixels have between a half and twice as many samples as planned in the mean.
                plan.samples() / (2 * SAMPLES_PER_PASS));
        return traits.dividesIntoPasses() && most >= FEWEST_PASSES ? Integer.highestOneBit((int) most) : 1;
    }

    private static long paths(RenderSettings settings, RenderPlan plan) {
        double all = Math.max(Math.ceil(plan.samples() * settings.width() * settings.height()), 1);
        Check.that(all <= MOST_PATHS, "samples", "make too many paths: " + all + ", of at most " + MOST_PATHS);
        return (long) all;
    }

    private static int pathsPerBatch(long paths) {
        long size = PATHS_PER_BATCH;
        while ((paths + size - 1) / size > MOST_UNITS && size < 1 << 30) {
            size *= 2;
        }
        return (int) size;
    }

    /** Side of the blocks that tiles are not cut through. */
    int blockSide() {
        return blockSide;
    }

    /** The number of units. */
    public int count() {
        return count;
    }

    /** The number of batches of paths, which have the lowest numbers. The others are tiles or passes over them. */
    public int batches() {
        return batches;
    }

    /** Whether a unit is a batch of paths. */
    public boolean isBatch(int unit) {
        return Objects.checkIndex(unit, count) < batches;
    }

    /** Whether there are tiles. */
    boolean haveTiles() {
        return cut != null;
    }

    /** In how many passes each tile is made. */
    public int passes() {
        return passes;
    }

    /**
     * The memory that a picture takes while units are added up that can be taken out again.
     *
     * @param outline of the render
     * @param moreImages how many further images as large as the picture are needed
     */
    PictureMemory memory(RenderOutline outline, int moreImages) {
        PictureMemory.Films films = cut == null
                ? PictureMemory.Films.SPLATS
                : batches > 0 ? PictureMemory.Films.BOTH : PictureMemory.Films.TILES;
        boolean isLinear = outline.display().encoding() == Color.Encoding.LINEAR;
        return new PictureMemory(outline.settings(), isLinear, films, moreImages + (passes > 1 ? IMAGES_OF_PASSES : 0));
    }

    /** The reason why a picture must be in memory while units are added in any order; empty without one. */
    Optional<String> wholeInMemory(RenderPlan plan) {
        if (cut == null) {
            return FilmRoom.wholeInMemory(plan.method());
        }
        return passes > 1 ? Optional.of("a render of " + passes + " passes over each tile") : Optional.empty();
    }

    /** The tile that a unit belongs to, counted from 0. */
    int tile(int unit) {
        return (Objects.checkIndex(unit, count) - batches) / passes;
    }

    /** Which pass over its tile a unit is. */
    int pass(int unit) {
        return (unit - batches) % passes;
    }

    /** The pixels of a unit that is a tile or a pass over one, by their place in the whole picture. */
    public RenderSettings.Crop place(int unit) {
        return cut.place(tile(unit));
    }

    /** The number of paths of all batches, at least the plan's; all groups of batches have equally many. */
    public long paths() {
        return paths;
    }

    /** The first path of a batch. */
    long firstPath(int unit) {
        return (long) Objects.checkIndex(unit, batches) * pathsPerBatch;
    }

    /** The number of paths of a batch. */
    int paths(int unit) {
        return (int) Math.min(pathsPerBatch, paths - firstPath(unit));
    }
}

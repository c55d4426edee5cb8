package enlightenment.method.cluster;

import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.film.TilePasses;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.method.TileIntegrator;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.bidirectional.BidirectionalContinuation;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * The cluster method for physical light. Rays through the corners of a block's pixels find what is deterministic: surfaces, edges, and
 * light without random decisions, which is interpolated between them as a control variate. The first paths of each pixel show the variance
 * of paths, as a display would; the other paths are allocated by that. See docs/notes/cluster-sampler.md.
 *
 * <p>Unbiased, because a pixel's number of samples depends on the corners and on paths of other pixels only.
 */
public final class PhysicalClusterMethod implements TileIntegrator {
    /**
     * Side, in pixels, of the smallest blocks whose pixels share statistics and paths: 16. Larger than in classic shading, because the
     * errors of pixels that share paths are correlated, which is less visible the farther apart they lie (docs/notes/cluster-sampler.md).
     */
    private static final int LEAST_SIDE = 2 * FilmTile.BLOCK_SIDE;

    /** Side of the largest blocks. */
    private static final int MOST_SIDE = 64;

    /** The sides of a picture are at least this many times those of a block larger than the smallest. */
    private static final int SIDES = 20;

    /** The number of samples of each pixel in which path reuse is tried. */
    private static final int TRIED = 2;

    /** Binary logarithm of the largest number of first paths per pixel; more would improve the statistics little. */
    private static final int MOST_FIRST = 4;

    /**
     * Binary logarithm of the largest number of samples over which a path's deviation is assumed to be spread: beyond it shows in
     * proportion.
     */
    private static final int MOST_SPREAD = 6;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final double samplesPerPixel;
    private final double effort;

    /** By chessboard colour, the allocation of the block's pixels. */
    private final PhysicalAllocation[] allocations = new PhysicalAllocation[2];

    /** The limits of blocks, computed with the first block that is rendered. */
    private BlockLimits limits;

    private final PhysicalSurvey survey;
    private final PathNoise noise;
    private final SharingGain sharing = new SharingGain();
    private final Interpolation interpolation = new Interpolation();
    private final int blockSide;
    private final PixelGroup group;

    private final GroupPaths paths;
    private final int[] count = new int[PixelGroup.MOST_MEMBERS];
    private final SampleSpread[] spreads = new SampleSpread[PixelGroup.MOST_MEMBERS];

    /** Binary logarithm of the number of first paths of each pixel; and their colours, one after another. */
    private final int firstSamples;

    private final double[] first;
    /** Roughly the number of samples of a pixel's mean. */
    private final double spreadOver;

    /**
     * @param scene of physical shading
     * @param effort inverse of the smallest reduction of variance for which one more sample is taken
     * @param samples the expected number of camera rays per pixel: a share of them is the same for all pixels
     * @param reusesLight whether light subpaths are reused, too, where the scene allows it
     */
    public PhysicalClusterMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            double effort,
            double samples,
            boolean reusesLight) {
        this(scene, settings, counters, effort, samples, reusesLight, firstOf(samples));
    }

    private PhysicalClusterMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            double effort,
            double samples,
            boolean reusesLight,
            int firstSamples) {
        this.scene = scene;
        this.settings = settings;
        this.effort = effort;
        samplesPerPixel = samples;
        this.firstSamples = firstSamples;
        blockSide = blockSide(settings);
        group = new PixelGroup(blockSide);
        first = new double[3 * blockSide * blockSide << firstSamples];
        spreadOver = Math.scalb(1.0, Math.min(Math.max(Math.getExponent(samples), 0), MOST_SPREAD));
        PathIntegrator tracer = GroupPaths.tracer(scene, counters, reusesLight);
        survey = new PhysicalSurvey(scene, settings, tracer, blockSide);
        noise = new PathNoise(scene.display, survey);
        paths = new GroupPaths(scene, settings, counters, tracer, group);
        for (int m = 0; m < PixelGroup.MOST_MEMBERS; m++) {
            spreads[m] = new SampleSpread();
        }
    }

    /**
     * Side, in pixels, of the blocks of a picture whose pixels share statistics and paths; a power of two. In a larger picture pixels that
     * are farther apart are as much alike, and there are more groups of them, whose errors average out.
     */
    public static int blockSide(RenderSettings settings) {
        int most = Math.min(settings.width(), settings.height()) / SIDES;
        return Math.min(Math.max(Integer.highestOneBit(most), LEAST_SIDE), MOST_SIDE);
    }

    /** Whether light subpaths can be reused in a scene. */
    public static boolean canReuseLight(CompiledScene scene) {
        return BidirectionalContinuation.isPossible(scene.physical);
    }

    private static int firstOf(double samples) {
        return Math.min(PhysicalAllocation.leastSamples(samples), MOST_FIRST);
    }

    /** Makes one that only surveys blocks, with half as many first paths: statistics over many blocks are precise enough. */
    static PhysicalClusterMethod looking(
            CompiledScene scene, RenderSettings settings, double samples, boolean reusesLight) {
        return looking(scene, settings, samples, reusesLight, Math.max(firstOf(samples) - 1, 0));
    }

    /** Makes one that only surveys blocks, with as many first paths as the picture has. */
    static PhysicalClusterMethod lookingAsPicture(
            CompiledScene scene, RenderSettings settings, double samples, boolean reusesLight) {
        return looking(scene, settings, samples, reusesLight, firstOf(samples));
    }

    private static PhysicalClusterMethod looking(
            CompiledScene scene, RenderSettings settings, double samples, boolean reusesLight, int first) {
        RayCounters counters = new RayCounters(scene.kindNames.size());
        return new PhysicalClusterMethod(
                scene, settings, counters, EffortSearch.LEAST_EFFORT, samples, reusesLight, first);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        paths.stopWhen(cancelled);
    }

    /** False: allocation uses the first samples of other pixels. */
    @Override
    public boolean dividesIntoPasses() {
        return false;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.checkOne(pass, passes);
        Block.forEach(tile, settings.width(), settings.height(), blockSide, block -> render(block, tile));
    }

    private void render(Block block, FilmTile tile) {
        look(block, settings.seed());
        tile.addSurveyRays(survey.rays());
        for (int colour = 0; colour < 2; colour++) {
            allocations[colour] = new PhysicalAllocation(limitedEffort(block, colour), samplesPerPixel);
        }
        for (int number = 0; number < group.count; number++) {
            group.gather(block, number);
            if (group.overlaps(tile)) {
                paths.toPixels(settings.seed());
                renderGroup(tile);
            }
        }
    }

    /**
     * The effort with which the pixels of a colour stay within the limits; like their needs, it depends on the other colour's paths only.
     */
    private double limitedEffort(Block block, int colour) {
        if (limits == null) {
            limits = PhysicalClusterCost.limits(scene, settings, samplesPerPixel);
        }
        if (survey.isEmpty()) {
            return EffortSearch.LEAST_EFFORT;
        }
        double spent = samples(block, colour, effort);
        double limited = limits.limited(spent);
        return limited == spent ? effort : EffortSearch.effort(e -> samples(block, colour, e), limited);
    }

    /** The mean number of camera rays per pixel of a colour, the survey's included. */
    private double samples(Block block, int colour, double ofEffort) {
        PhysicalAllocation allocation = new PhysicalAllocation(ofEffort, samplesPerPixel);
        long sum = 0;
        int pixels = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                if (PathNoise.field(i, j) == colour) {
                    sum += 1L << samples(allocation, i, j, block.x() + i, block.y() + j);
                    pixels++;
                }
            }
        }
        return pixels == 0 ? 0 : (double) sum / pixels + (double) survey.rays() / block.pixels();
    }

    private int samples(PhysicalAllocation allocation, int i, int j, int x, int y) {
        return allocation.samples(noise.variance(i, j), noise.edge(i, j), noise.cost(i, j), Dither.at(x, y));
    }

    private void renderGroup(FilmTile tile) {
        int most = 0;
        for (int m = 0; m < group.members; m++) {
            int i = group.column[m];
            int j = group.row[m];
            count[m] = 1 << samples(allocations[PathNoise.field(i, j)], i, j, group.x(m), group.y(m));
            most = Math.max(most, count[m]);
            spreads[m].begin(count[m]);
        }
        int done = 1 << firstSamples;
        for (int s = 0; s < most; s++) {
            if (s >= done) {
                sample(s);
            }
            for (int m = 0; m < group.members; m++) {
                if (s < count[m]) {
                    add(m, s, tile);
                }
            }
        }
        for (int m = 0; m < group.members; m++) {
            finish(m, tile);
        }
    }

    private void add(int m, int s, FilmTile tile) {
        int x = group.x(m);
        int y = group.y(m);
        if (!tile.contains(x, y)) {
            return;
        }
        double[] from = first;
        int at = 3 * ((group.inBlock(m) << firstSamples) + s);
        if (s >= 1 << firstSamples) {
            from = paths.color(m);
            at = 0;
        }
        if (s < 2) {
            paths.place(spreads[m], m, s);
        } else {
            spreads[m].at(0, 0);
        }
        tile.add(x, y, from[at], from[at + 1], from[at + 2]);
        spreads[m].add(from[at], from[at + 1], from[at + 2]);
    }

    private void finish(int m, FilmTile tile) {
        int x = group.x(m);
        int y = group.y(m);
        if (!tile.contains(x, y)) {
            return;
        }
        if (noise.isQuiet(group.column[m], group.row[m])) {
            interpolation.between(survey, group.column[m], group.row[m]);
            tile.known(x, y, interpolation.mean(0), interpolation.mean(1), interpolation.mean(2), 0);
        } else {
            tile.known(x, y, 0, 0, 0, 0);
        }
        tile.spread(x, y, spreads[m]);
    }

    /** Surveys the block and takes the first samples of its pixels. */
    void look(Block block, long seed) {
        double width = settings.width();
        double height = settings.height();
        paths.beginTile(
                block.x() / width,
                block.y() / height,
                (block.x() + block.width()) / width,
                (block.y() + block.height()) / height);
        survey.take(block);
        int count = 1 << firstSamples;
        noise.begin(block, count, spreadOver);
        if (survey.isEmpty()) {
            Arrays.fill(first, 0);
            noise.finishQuiet();
            return;
        }
        int tried = Math.min(TRIED, count);
        sharing.begin();
        for (int number = 0; number < group.count; number++) {
            takeFirst(block, seed, number, 0, tried);
        }
        sharing.finish();
        for (int number = 0; number < group.count; number++) {
            takeFirst(block, seed, number, tried, count);
        }
        noise.finish();
    }

    /** Takes a range of the first samples of a group's pixels. */
    private void takeFirst(Block block, long seed, int number, int from, int to) {
        group.gather(block, number);
        paths.toPixels(seed);
        Arrays.fill(count, 0, group.members, to);
        for (int s = from; s < to; s++) {
            sample(s);
            for (int m = 0; m < group.members; m++) {
                int at = 3 * ((group.inBlock(m) << firstSamples) + s);
                System.arraycopy(paths.color(m), 0, first, at, 3);
                paths.tell(noise, m, s);
            }
        }
    }

    /** The number of rays of the last survey. */
    int surveyRays() {
        return survey.rays();
    }

    /** The variance of a sample of the last block's pixel, as shown. */
    double noise(int i, int j) {
        return noise.variance(i, j);
    }

    /** The variance, as shown, of an edge through the last block's pixel. */
    double edge(int i, int j) {
        return noise.edge(i, j);
    }

    /** The mean cost of a path through the last block's pixel. */
    double cost(int i, int j) {
        return noise.cost(i, j);
    }

    /** Takes the sample with this number for each member of the group that needs it. */
    private void sample(int number) {
        if (survey.isEmpty()) {
            // All visible light is deterministic, and known already.
            paths.clear(number, count);
            return;
        }
        paths.take(number, count, sharing);
        for (int m = 0; m < group.members; m++) {
            if (paths.has(m) && noise.isQuiet(group.column[m], group.row[m])) {
                interpolation.between(survey, group.column[m], group.row[m]);
                paths.subtract(interpolation, m);
            }
        }
    }
}

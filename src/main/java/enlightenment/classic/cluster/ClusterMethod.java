package enlightenment.classic.cluster;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.film.TilePasses;
import enlightenment.method.Block;
import enlightenment.method.Dither;
import enlightenment.method.TileIntegrator;
import enlightenment.method.cluster.Interpolation;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Distribution;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * The paper's ray clusters: a survey of evenly spaced rays shows where samples are needed and where lights are partly hidden;
 * samples are allocated accordingly, the survey's interpolated colours are their control variate, and clusters of rays that met
 * the same surface and light propose further light points. See docs/notes/cluster-sampler.md.
 *
 * <p>Unbiased, because every decision about a pixel is made before and without its own samples: numbers of samples from the
 * survey, proposals from the survey and the pixels before it.
 */
public final class ClusterMethod implements TileIntegrator {
    /** A block is surveyed again, with more light points, if it will take at least this many times as many of them itself. */
    private static final double LEAST_USE_OF_SECOND_SURVEY = 1;

    /** Points of the rarer kind (visible or hidden) that make a good fit, and how many surveys to take at most to find them. */
    private static final int ENOUGH_TO_LEARN = 96;

    private static final int MOST_LOOKS = 4;

    /** Where the rarer kind of points has a larger share than this, proposals gain little. */
    private static final double RARE = 0.2;

    /**
     * Binary logarithm of the largest number of first samples of a pixel that are evidence. All that every pixel takes anyway are, up to
     * here: 4,096 in a block meet wires of a hundredth of a pixel, and their colours take 96 KiB for each thread.
     */
    static final int MOST_FIRST = 6;

    private static final int PIXELS = FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BlockAllocation allocation;
    private final ClassicShader shader;
    private final Survey survey;
    private final SampleDemand needs = new SampleDemand();
    private final ClusterGuide guide;
    private final ClusterRecorder recorder;
    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    private final Interpolation interpolation = new Interpolation();

    private final Evidence evidence = new Evidence();

    /**
     * Binary logarithm of how many samples of each pixel are evidence about the others, negative for none; and their colours, one after
     * another.
     */
    private final int firstSamples;

    private final double[] first;

    /** Binary logarithm of the light points per sample of each pixel. */
    private final int[] points = new int[PIXELS];

    private boolean guided;
    private boolean looked;
    private boolean lookedMore;

    /** Samples that were taken to look at the block only, and are no part of the picture. */
    private int raysApart;

    /**
     * @param effort how much is spent: the inverse of the smallest reduction of variance for which one more sample is taken
     * @param samples the camera rays per pixel that this is expected to take: a share of them goes everywhere
     */
    public ClusterMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            Distribution proposal,
            double effort,
            double samples) {
        this(scene, settings, counters, proposal, effort, samples, null);
    }

    /**
     * The method with a listener that receives the clusters of each block when it is done.
     *
     * @param effort how much is spent: the inverse of the smallest reduction of variance for which one more sample is taken
     * @param samples the camera rays per pixel that this is expected to take: a share of them goes everywhere
     * @param clusters called from the thread that renders; null without a listener
     */
    public ClusterMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            Distribution proposal,
            double effort,
            double samples,
            Consumer<List<ClusterStatistics>> clusters) {
        this.scene = scene;
        this.settings = settings;
        allocation = ClusterCost.allocation(scene, settings, effort, samples);
        firstSamples = allocation.isLimited() ? allocation.apart() : firstSamples(samples);
        first = new double[firstSamples < 0 ? 0 : 3 * PIXELS << firstSamples];
        shader = new ClassicShader(scene, 1, counters);
        recorder = clusters == null ? null : new ClusterRecorder(clusters);
        if (recorder != null) {
            shader.report().keepRays();
        }
        survey = new Survey(scene, settings, shader, recorder);
        guide = new ClusterGuide(proposal, counters);
    }

    /**
     * Binary logarithm of how many samples of each pixel are evidence about the others.
     *
     * @param samples how many are spent per pixel in the mean
     */
    static int firstSamples(double samples) {
        return Math.min(Allocation.leastSamples(samples), MOST_FIRST);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        shader.stopWhen(cancelled);
    }

    /** Samples learn from those before. */
    @Override
    public boolean dividesIntoPasses() {
        return false;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.checkOne(pass, passes);
        Block.forEach(tile, settings.width(), settings.height(), FilmTile.BLOCK_SIDE, block -> render(block, tile));
    }

    private void render(Block block, FilmTile tile) {
        if (recorder != null) {
            recorder.begin(block);
        }
        prepare(block);
        look(block, allocation.isLimited() ? ClusterCost.seed(settings) : settings.seed());
        tile.addSurveyRays(surveyRays());
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                boolean wanted = tile.contains(block.x() + i, block.y() + j);
                // Proposals learn from the pixels before, also from those that are not part of the tile.
                if (wanted || guided) {
                    renderPixel(block, i, j, wanted ? tile : null);
                }
            }
            if (guided) {
                guide.learn();
            }
        }
        if (recorder != null) {
            recorder.end(guided ? guide : null);
        }
    }

    /** Surveys the block and works out what its pixels need. */
    void prepare(Block block) {
        double width = settings.width();
        double height = settings.height();
        shader.beginTile(
                block.x() / width,
                block.y() / height,
                (block.x() + block.width()) / width,
                (block.y() + block.height()) / height);
        shader.guide(null);
        survey.take(block);
        needs.of(survey, block);
        raysApart = 0;
        limit(block);
        guided = false;
        lookedMore = isWorthLearning(block);
        if (lookedMore) {
            guide.reset();
            for (int round = 1; round <= MOST_LOOKS && guide.rarePoints() < ENOUGH_TO_LEARN; round++) {
                survey.takeMore(guide, round);
            }
            needs.of(survey, block);
            guided = guide.fit();
            if (guided) {
                needs.guided(guide.gain());
                shader.guide(guide);
            }
            limit(block);
        }
    }

    /** Keeps what is spent on the block within limits, as far as its needs are known: of these no sample of the picture is part. */
    private void limit(Block block) {
        if (survey.isEmpty()) {
            allocation.withoutLimits();
        } else {
            allocation.limit(needs, block, surveyRays());
        }
    }

    SampleDemand needs() {
        return needs;
    }

    /** Whether the block learns proposals if enough samples are spent on it. */
    boolean mayLearn() {
        double rare = survey.rareShare();
        return rare > 0 && rare <= RARE;
    }

    /** Whether it was surveyed again, given what is spent on it. */
    boolean hasLookedMore() {
        return lookedMore;
    }

    /** How many rays were taken to find what the block needs, beside samples of the picture. */
    int surveyRays() {
        return survey.rays() + raysApart;
    }

    /** Whether the block will take enough light points, of lights that are little hidden or little seen, to repay a second survey. */
    private boolean isWorthLearning(Block block) {
        if (!mayLearn()) {
            return false;
        }
        long points = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                points += 1L << allocation.ofBlock().lightPoints(needs.light[FilmTile.BLOCK_SIDE * j + i]);
            }
        }
        return points >= LEAST_USE_OF_SECOND_SURVEY * survey.pointsOfMore();
    }

    /**
     * Takes the first samples of each pixel, and lets each learn from those of the others. Not where proposals learn: they would
     * pass on to a pixel what others have learned from its own samples.
     *
     * <p>Where what is spent on a block is limited, that depends on the needs of all pixels together, and so on all these samples: they are
     * no part of the picture.
     */
    void look(Block block, long seed) {
        boolean apart = allocation.isLimited();
        looked = !guided && !survey.isEmpty() && firstSamples >= 0;
        evidence.begin(apart);
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                setPoints(block, i, j, apart);
                if (looked) {
                    turn(block, i, j, seed);
                    look(block, i, j);
                }
            }
        }
        if (looked) {
            evidence.raise(needs, block);
        }
        if (apart) {
            raysApart = looked ? block.pixels() << firstSamples : 0;
            looked = false;
            limit(block);
            setPoints(block);
        }
    }

    private void setPoints(Block block) {
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                setPoints(block, i, j, false);
            }
        }
    }

    /** Decides on the light points of a pixel's samples; one where it is only looked at. */
    private void setPoints(Block block, int i, int j, boolean one) {
        int k = FilmTile.BLOCK_SIDE * j + i;
        int wanted = one || needs.lightIsSettled ? 0 : allocation.ofBlock().lightPoints(needs.light[k]);
        points[k] = Math.max(wanted - samples(block, i, j), 0);
    }

    private void look(Block block, int i, int j) {
        int k = FilmTile.BLOCK_SIDE * j + i;
        int count = 1 << firstSamples;
        long key = survey.commonKey(i, j);
        double sum = 0;
        for (int s = 0; s < count; s++) {
            sample(block.x() + i, block.y() + j, i, j, s);
            System.arraycopy(color, 0, first, 3 * (count * k + s), 3);
            sum += Evidence.of(color, shader.report().pathKey == key, needs, k, 1 << points[k]);
        }
        evidence.tell(k, key != Survey.DIFFERENT, sum / count);
    }

    private int samples(Block block, int i, int j) {
        int k = FilmTile.BLOCK_SIDE * j + i;
        return allocation
                .ofBlock()
                .samples(needs.film[k], needs.edge[k], needs.light[k], Dither.at(block.x() + i, block.y() + j));
    }

    /** Turns to a pixel. */
    private void turn(Block block, int i, int j, long seed) {
        shader.lightPoints(1 << points[FilmTile.BLOCK_SIDE * j + i]);
        sampler.pixel(seed, block.x() + i, block.y() + j);
        interpolation.between(survey, i, j);
        if (guided) {
            guide.pixel(i, j);
        }
    }

    private void renderPixel(Block block, int i, int j, FilmTile tile) {
        int k = FilmTile.BLOCK_SIDE * j + i;
        int x = block.x() + i;
        int y = block.y() + j;
        turn(block, i, j, settings.seed());
        int samples = 1 << samples(block, i, j);
        int done = looked ? 1 << firstSamples : 0;
        spread.begin(samples);
        for (int s = 0; s < samples; s++) {
            if (s < done) {
                sampler.sample(s);
                spread.at(sampler.filmX(), sampler.filmY());
                System.arraycopy(first, 3 * (done * k + s), color, 0, 3);
            } else {
                sample(x, y, i, j, s);
            }
            if (tile != null) {
                tile.add(x, y, color[0], color[1], color[2]);
                spread.add(color[0], color[1], color[2]);
            }
        }
        if (tile != null) {
            tile.known(
                    x,
                    y,
                    interpolation.mean(0),
                    interpolation.mean(1),
                    interpolation.mean(2),
                    needs.ofLight(k, 1 << points[k]));
            tile.spread(x, y, spread);
        }
    }

    /** Sets the colour of a sample minus the control variate: the interpolation of the corners there. */
    private void sample(int x, int y, int i, int j, int index) {
        sampler.sample(index);
        double dx = sampler.filmX();
        double dy = sampler.filmY();
        spread.at(dx, dy);
        scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), ray);
        if (guided) {
            guide.at(i + dx, j + dy);
        }
        if (recorder != null) {
            recorder.camera(ray);
        }
        shader.shade(ray, sampler, color);
        if (recorder != null) {
            recorder.read(shader.report());
        }
        if (guided) {
            guide.read(shader.report());
        }
        interpolation.subtract(dx, dy, color);
    }
}

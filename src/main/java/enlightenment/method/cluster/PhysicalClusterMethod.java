package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.film.TilePasses;
import enlightenment.method.Dither;
import enlightenment.method.TileIntegrator;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.PathTracer;
import java.util.function.BooleanSupplier;

/**
 * The sampler of {@link ClusterMethod} for physical light. Rays through the corners of a block's pixels show what is certain: surfaces,
 * edges, and light that is not left to chance, which is interpolated between them as a control variate. The first paths of each pixel show
 * how much paths vary, in what a screen shows; by that the other paths are allotted. See docs/cluster-sampler.md.
 *
 * <p>Unbiased, because a pixel's number of samples depends on the corners and on paths of other pixels only.
 */
public final class PhysicalClusterMethod implements TileIntegrator {
    private static final int PIXELS = Block.SIDE * Block.SIDE;

    /** Binary logarithm of the largest number of first paths; more would tell little more. */
    private static final int MOST_FIRST = 4;

    /** Binary logarithm of the largest number of samples that a path's deviation is thought to be spread over: then it shows in proportion. */
    private static final int MOST_SPREAD = 6;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final PhysicalAllocation allocation;
    private final PathTracer tracer;
    private final PhysicalSurvey survey;
    private final PathNoise noise;
    private final Interpolation interpolation = new Interpolation();
    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];
    private final double[] certain = new double[3];

    /** Binary logarithm of the number of first paths of each pixel; and their colours, one after another. */
    private final int firstSamples;

    private final double[] first;

    /** How many samples a pixel's mean is of, about. */
    private final double spreadOver;

    /** Whether the pixel that was turned to has a known part. */
    private boolean isQuiet;

    /**
     * @param scene of physical shading
     * @param effort how much is spent: the inverse of the smallest reduction of variance for which one more sample is taken
     * @param samples the camera rays per pixel that this is expected to take: a share of them goes everywhere
     */
    public PhysicalClusterMethod(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double effort, double samples) {
        this.scene = scene;
        this.settings = settings;
        allocation = new PhysicalAllocation(effort, samples);
        firstSamples = Math.min(PhysicalAllocation.leastSamples(samples), MOST_FIRST);
        first = new double[3 * PIXELS << firstSamples];
        spreadOver = Math.scalb(1.0, Math.min(Math.max(Math.getExponent(samples), 0), MOST_SPREAD));
        tracer = new PathTracer(scene, counters);
        survey = new PhysicalSurvey(scene, settings, tracer);
        noise = new PathNoise(scene.display, survey);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        tracer.stopWhen(cancelled);
    }

    /** Pixels learn from the first samples of others. */
    @Override
    public boolean dividesIntoPasses() {
        return false;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.checkOne(pass, passes);
        int right = tile.x + tile.width;
        int bottom = tile.y + tile.height;
        for (int y = tile.y / Block.SIDE * Block.SIDE; y < bottom; y += Block.SIDE) {
            for (int x = tile.x / Block.SIDE * Block.SIDE; x < right; x += Block.SIDE) {
                render(Block.around(x, y, settings.width(), settings.height()), tile);
            }
        }
    }

    private void render(Block block, FilmTile tile) {
        look(block, settings.seed());
        tile.addSurveyRays(survey.rays());
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                if (tile.contains(block.x() + i, block.y() + j)) {
                    renderPixel(block, i, j, tile);
                }
            }
        }
    }

    /** Surveys the block and takes the first samples of its pixels. */
    void look(Block block, long seed) {
        double width = settings.width();
        double height = settings.height();
        tracer.beginTile(
                block.x() / width,
                block.y() / height,
                (block.x() + block.width()) / width,
                (block.y() + block.height()) / height);
        survey.take(block);
        int count = 1 << firstSamples;
        noise.begin(block, count, spreadOver);
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                turn(block, i, j, seed);
                int from = 3 * (Block.SIDE * j + i) << firstSamples;
                for (int s = 0; s < count; s++) {
                    sample(block.x() + i, block.y() + j, s);
                    System.arraycopy(color, 0, first, from + 3 * s, 3);
                    tell(i, j, s);
                }
            }
        }
        noise.finish();
    }

    /** Tells of the last sample. */
    private void tell(int i, int j, int s) {
        long key = tracer.certain(certain);
        double known = isQuiet ? 0 : 1;
        noise.tell(
                i,
                j,
                s,
                key,
                2 + tracer.events(),
                color[0] - known * certain[0],
                color[1] - known * certain[1],
                color[2] - known * certain[2]);
    }

    /** How many rays the last survey took. */
    int surveyRays() {
        return survey.rays();
    }

    /** What the last block's pixel needs. */
    double noise(int i, int j) {
        return noise.variance(i, j);
    }

    /** The same for an edge. */
    double edge(int i, int j) {
        return noise.edge(i, j);
    }

    /** What a path through it costs. */
    double cost(int i, int j) {
        return noise.cost(i, j);
    }

    private void turn(Block block, int i, int j, long seed) {
        sampler.pixel(seed, block.x() + i, block.y() + j);
        isQuiet = noise.isQuiet(i, j);
        if (isQuiet) {
            interpolation.between(survey, i, j);
        }
    }

    private void renderPixel(Block block, int i, int j, FilmTile tile) {
        int x = block.x() + i;
        int y = block.y() + j;
        turn(block, i, j, settings.seed());
        int samples = 1
                << allocation.samples(
                        noise.variance(i, j), noise.edge(i, j), noise.cost(i, j), Dither.at(x, y));
        int done = 1 << firstSamples;
        int from = 3 * (Block.SIDE * j + i) << firstSamples;
        spread.begin(samples);
        for (int s = 0; s < samples; s++) {
            if (s < done) {
                sampler.sample(s);
                spread.at(sampler.filmX(), sampler.filmY());
                System.arraycopy(first, from + 3 * s, color, 0, 3);
            } else {
                sample(x, y, s);
            }
            tile.add(x, y, color[0], color[1], color[2]);
            spread.add(color[0], color[1], color[2]);
        }
        if (isQuiet) {
            tile.known(x, y, interpolation.mean(0), interpolation.mean(1), interpolation.mean(2), 0);
        } else {
            tile.known(x, y, 0, 0, 0, 0);
        }
        tile.spread(x, y, spread);
    }

    /** Sets the value of a sample, less the control variate. */
    private void sample(int x, int y, int index) {
        sampler.sample(index);
        double dx = sampler.filmX();
        double dy = sampler.filmY();
        spread.at(dx, dy);
        scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), ray);
        tracer.shade(ray, sampler, color);
        if (isQuiet) {
            interpolation.subtract(dx, dy, color);
        }
    }
}

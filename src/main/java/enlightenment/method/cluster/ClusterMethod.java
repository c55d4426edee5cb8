package enlightenment.method.cluster;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.geometry.Ray;
import enlightenment.method.TileMethod;
import enlightenment.sampling.Distribution;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.ClassicShader;
import enlightenment.shading.SampleAddress;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * The paper's ray clusters: evenly spaced rays show where samples are needed and where lights are partly hidden; samples
 * go there, and clusters of rays that met the same surface and light propose further ones. See docs/cluster-sampler.md.
 *
 * <p>Unbiased, because every decision about a pixel is made before and without its own samples: numbers of samples from the
 * survey, proposals from the survey and the pixels before it.
 */
public final class ClusterMethod implements TileMethod {
    /** Learning looks at more light points; the block must be going to take so many times as many. */
    private static final double PATIENCE = 1;

    /** Points of the rarer kind that make a good fit, and how often to look for them. */
    private static final int ENOUGH_TO_LEARN = 96;

    private static final int MOST_LOOKS = 4;

    /** A share of points above this leaves little to gain by seeking them. */
    private static final double RARE = 0.2;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final Allocation allocation;
    private final ClassicShader shader;
    private final Survey survey;
    private final Needs needs = new Needs();
    private final ClusterGuide guide;
    private final ClusterRecorder recorder;
    private final Ray ray = new Ray();
    private final SampleAddress address = new SampleAddress();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    /** Interpolation of the corners' colours: constant, by x, by y and by xy, for red, green and blue. */
    private final double[] corners = new double[12];

    private boolean guided;

    /** @param effort how much is spent: the inverse of the variance that is worth one more sample */
    public ClusterMethod(
            CompiledScene scene, RenderSettings settings, RayCounters counters, Distribution proposal, double effort) {
        this(scene, settings, counters, proposal, effort, null);
    }

    /**
     * The same, showing the clusters of each block when it is done.
     *
     * @param clusters called from the thread that renders; null for nobody
     */
    public ClusterMethod(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            Distribution proposal,
            double effort,
            Consumer<List<ClusterRecord>> clusters) {
        this.scene = scene;
        this.settings = settings;
        allocation = new Allocation(effort);
        shader = new ClassicShader(scene, 1, counters);
        recorder = clusters == null ? null : new ClusterRecorder(clusters);
        shader.observer(recorder);
        survey = new Survey(scene, settings, shader, recorder);
        guide = new ClusterGuide(proposal, counters);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        shader.stopWhen(cancelled);
    }

    @Override
    public void render(FilmTile tile) {
        int right = tile.x + tile.width;
        int bottom = tile.y + tile.height;
        for (int y = tile.y / Block.SIDE * Block.SIDE; y < bottom; y += Block.SIDE) {
            for (int x = tile.x / Block.SIDE * Block.SIDE; x < right; x += Block.SIDE) {
                render(Block.around(x, y, settings.width(), settings.height()), tile);
            }
        }
    }

    private void render(Block block, FilmTile tile) {
        if (recorder != null) {
            recorder.begin(block);
        }
        prepare(block);
        tile.addSurveyRays(survey.rays());
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                boolean wanted = tile.contains(block.x() + i, block.y() + j);
                // The pixels before a pixel teach its proposals, whether they are wanted or not.
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
        guided = false;
        if (isWorthLearning(block)) {
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
        }
    }

    Needs needs() {
        return needs;
    }

    /** Whether the block is one that learns if enough is to be spent on it. */
    boolean mayLearn() {
        double rare = survey.rareShare();
        return rare > 0 && rare <= RARE;
    }

    int surveyRays() {
        return survey.rays();
    }

    /** Whether the block is going to ask so often about lights of which so little is seen or hidden. */
    private boolean isWorthLearning(Block block) {
        if (!mayLearn()) {
            return false;
        }
        long points = 0;
        for (int j = 0; j < block.height(); j++) {
            for (int i = 0; i < block.width(); i++) {
                points += 1L << allocation.lightPoints(needs.light[Block.SIDE * j + i]);
            }
        }
        return points >= PATIENCE * survey.pointsOfMore();
    }

    private void renderPixel(Block block, int i, int j, FilmTile tile) {
        int k = Block.SIDE * j + i;
        int level = allocation.samples(needs.film[k], needs.edge[k], needs.light[k]);
        int points = needs.lightIsSettled ? 0 : Math.max(allocation.lightPoints(needs.light[k]) - level, 0);
        shader.lightPoints(1 << points);
        int x = block.x() + i;
        int y = block.y() + j;
        address.pixel(settings.seed(), x, y);
        interpolate(i, j);
        if (guided) {
            guide.pixel(i, j);
        }
        int samples = 1 << level;
        spread.begin(samples);
        for (int s = 0; s < samples; s++) {
            sample(x, y, i, j, s);
            if (tile != null) {
                tile.add(x, y, color[0], color[1], color[2]);
                spread.add(color[0], color[1], color[2]);
            }
        }
        if (tile != null) {
            tile.known(x, y, mean(0), mean(1), mean(2), needs.ofLight(k, 1 << points));
            tile.spread(x, y, spread);
        }
    }

    /** Sets the colour of a sample minus what the corners let expect there. */
    private void sample(int x, int y, int i, int j, int index) {
        address.sample(index);
        double dx = address.filmX();
        double dy = address.filmY();
        spread.at(dx, dy);
        scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), ray);
        if (guided) {
            guide.at(i + dx, j + dy);
        }
        if (recorder != null) {
            recorder.camera(ray);
        }
        shader.shade(ray, address, color);
        double dxy = dx * dy;
        for (int c = 0; c < 3; c++) {
            int k = 4 * c;
            color[c] -= Math.fma(
                    corners[k + 3], dxy, Math.fma(corners[k + 2], dy, Math.fma(corners[k + 1], dx, corners[k])));
        }
    }

    private void interpolate(int i, int j) {
        int upper = 3 * Survey.node(i, j);
        int lower = upper + 3 * Survey.SIDE;
        for (int c = 0; c < 3; c++) {
            double p = survey.rgb[upper + c];
            double q = survey.rgb[upper + 3 + c];
            double r = survey.rgb[lower + c];
            double s = survey.rgb[lower + 3 + c];
            corners[4 * c] = p;
            corners[4 * c + 1] = q - p;
            corners[4 * c + 2] = r - p;
            corners[4 * c + 3] = p - q - r + s;
        }
    }

    /** The mean of the interpolation over the pixel. */
    private double mean(int c) {
        int k = 4 * c;
        return corners[k] + (corners[k + 1] + corners[k + 2]) / 2 + corners[k + 3] / 4;
    }
}

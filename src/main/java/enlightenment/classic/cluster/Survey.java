package enlightenment.classic.cluster;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.classic.shading.PathReport;
import enlightenment.film.FilmTile;
import enlightenment.method.Block;
import enlightenment.method.cluster.Corners;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;

/**
 * The paper's evenly spaced rays: one through each corner of the block's pixels. They are no samples of the pixels; they show
 * where samples are needed, and the colour that is interpolated between them is a control variate: samples estimate only the
 * difference.
 *
 * <p>A corner's ray is a pure function of scene, seed and corner, so that neighbouring blocks see the same at their border.
 */
final class Survey extends Corners {
    /** Light points of a corner's ray at first, and where it turns out that a light is partly hidden. */
    private static final int FEW = 4;

    private static final int MANY = 16;

    /**
     * The points around a pixel alone would miss what is rare, those of the block alone would blur what is sharp: the block counts like
     * this many points.
     */
    private static final int BLOCK_POINTS = 32;

    /** Keeps the survey's random numbers apart from those of pixels, which have the same places. */
    private static final long PURPOSE = 0x737572766579L;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final ClassicShader shader;
    private final long seed;
    private final ClusterRecorder recorder;
    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final double[] color = new double[3];

    private final int[] asked = new int[nodes];
    private final int[] blocked = new int[nodes];
    private final double[] contrast = new double[nodes];
    private final double[] spread = new double[nodes];
    private boolean spreads;
    private boolean empty;
    private Block block;
    private int askedInAll;
    private int blockedInAll;
    private int rays;

    Survey(CompiledScene scene, RenderSettings settings, ClassicShader shader, ClusterRecorder recorder) {
        super(FilmTile.BLOCK_SIDE);
        this.recorder = recorder;
        this.scene = scene;
        this.settings = settings;
        this.shader = shader;
        seed = Hash.of(settings.seed(), PURPOSE);
    }

    /** Follows a ray through each corner of the pixels of a block. */
    void take(Block target) {
        block = target;
        rays = 0;
        askedInAll = 0;
        blockedInAll = 0;
        spreads = false;
        shader.lightPoints(FEW);
        empty = shader.seesNothing();
        if (empty) {
            lookForAll();
            return;
        }
        for (int j = 0; j <= block.height(); j++) {
            for (int i = 0; i <= block.width(); i++) {
                look(i, j, 0);
            }
        }
    }

    /** Where there is only the background, the ray of one corner stands for all. */
    private void lookForAll() {
        look(0, 0, 0);
        for (int k = 1; k < nodes; k++) {
            System.arraycopy(rgb, 0, rgb, 3 * k, 3);
            keys[k] = keys[0];
            asked[k] = 0;
            blocked[k] = 0;
            contrast[k] = 0;
            spread[k] = 0;
        }
    }

    /**
     * Follows the rays again, with more light points, through the corners where something may hide a light.
     *
     * @param round 1, 2, …: each has random numbers of its own
     */
    void takeMore(ClusterGuide guide, int round) {
        shader.lightPoints(MANY);
        shader.guide(guide);
        for (int j = 0; j <= block.height(); j++) {
            for (int i = 0; i <= block.width(); i++) {
                if (asked[node(i, j)] > 0) {
                    guide.at(i, j);
                    look(i, j, round);
                    guide.read(shader.report());
                }
            }
        }
        shader.guide(null);
    }

    private void look(int i, int j, int round) {
        int column = block.x() + i;
        int row = block.y() + j;
        sampler.pixel(seed, column, row);
        sampler.sample(round);
        scene.camera.ray((double) column / settings.width(), (double) row / settings.height(), ray);
        if (recorder != null) {
            recorder.camera(ray);
        }
        shader.shade(ray, sampler, color);
        PathReport report = shader.report();
        if (recorder != null) {
            recorder.read(report);
        }
        int k = node(i, j);
        int points = report.shadowRays;
        if (round == 0) {
            System.arraycopy(color, 0, rgb, 3 * k, 3);
            asked[k] = 0;
            blocked[k] = 0;
        } else {
            join(k, (double) points / Math.max(asked[k] + points, 1));
        }
        keys[k] = report.pathKey;
        asked[k] += points;
        blocked[k] += report.blockedShadowRays;
        contrast[k] = report.visibilityContrast;
        spread[k] = report.colorVariance;
        spreads |= spread[k] > 0;
        askedInAll += points;
        blockedInAll += report.blockedShadowRays;
        rays++;
    }

    /** Lets another look count for a share of the corner's colour. */
    private void join(int node, double share) {
        for (int c = 0; c < 3; c++) {
            rgb[3 * node + c] += share * (color[c] - rgb[3 * node + c]);
        }
    }

    /** The share of the rarer kind of light points, hidden or visible; 0 if all are of one kind. */
    double rareShare() {
        return askedInAll == 0 ? 0 : (double) Math.min(blockedInAll, askedInAll - blockedInAll) / askedInAll;
    }

    /** How many light points {@link #takeMore} would look at, if it has not yet. */
    long pointsOfMore() {
        return (long) askedInAll * MANY / FEW;
    }

    /** Whether the block is known to show nothing but the background. */
    boolean isEmpty() {
        return empty;
    }

    boolean hasDoubtfulLight() {
        return askedInAll > 0 || spreads;
    }

    /** How many rays were followed. */
    int rays() {
        return rays;
    }

    /**
     * The variance of the colour of one sample in pixel (i, j) that comes from the choice of its light point, if it takes
     * one: that of its cosine, and the contrast of visibility times p (1 − p), where p is the share of hidden points around the
     * pixel, towards which that of the block counts like {@link #BLOCK_POINTS} points.
     */
    double lightVariance(int i, int j) {
        int points = 0;
        int hidden = 0;
        double stake = 0;
        double ofCosine = 0;
        for (int k = 0; k < 4; k++) {
            int node = node(i + (k & 1), j + (k >> 1));
            points += asked[node];
            hidden += blocked[node];
            stake = Math.max(stake, contrast[node]);
            ofCosine += spread[node] / 4;
        }
        if (stake == 0) {
            return ofCosine;
        }
        double before = (blockedInAll + 0.5) / (askedInAll + 1);
        double p = (hidden + BLOCK_POINTS * before) / (points + BLOCK_POINTS);
        return ofCosine + stake * p * (1 - p);
    }

    /** The variance of a corner's own colour for the same reason. */
    double lightNoise(int node) {
        if (contrast[node] == 0 || blocked[node] == 0 || blocked[node] == asked[node]) {
            return 0;
        }
        double p = (double) blocked[node] / asked[node];
        return contrast[node] * p * (1 - p) / asked[node];
    }
}

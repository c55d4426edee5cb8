package enlightenment.plan;

import enlightenment.compiled.CompiledScene;
import enlightenment.film.FilmTile;
import enlightenment.method.cluster.ClusterCost;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/** The plan for a number of samples per pixel: with which method they are taken, and at which level. */
final class SamplePlans {
    /** What a search for an error begins with, and what follows a picture without a survey, where there can be one. */
    static final double FIRST_OF_CLUSTER = 4;

    /**
     * With fewer samples per pixel than this, method {@code cluster} is exactly {@code raytrace}: its survey takes 1.27, every
     * pixel takes at least one, and what is left does not buy more than evenly spaced rays do. Measured: from 2.3 on fire and ice
     * to 2.6 on the keyhole, docs/cluster-laboratory.md.
     */
    static final double FEWEST_OF_CLUSTER = 2.45;

    /** The largest number with three digits that is still too few for a survey. */
    static final double MOST_WITHOUT_SURVEY = 2.44;

    /** Blocks that are surveyed to learn what an effort costs. */
    private static final int COST_BLOCKS = 512;

    private static final double PIXELS_OF_BLOCK = FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE;

    /** Rays of a survey per pixel: one at each corner of a block's pixels. */
    private static final double SURVEY_RAYS = (FilmTile.BLOCK_SIDE + 1) * (FilmTile.BLOCK_SIDE + 1) / PIXELS_OF_BLOCK;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final BooleanSupplier cancelled;
    private final boolean cluster;
    private final Map<Double, Double> efforts = new HashMap<>();
    private ClusterCost cost;

    SamplePlans(CompiledScene scene, RenderSettings settings, BooleanSupplier cancelled) {
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
        cluster = settings.method() == Method.CLUSTER;
    }

    /** The plan without a budget: antialias² samples per pixel. */
    RenderPlan ofAntialias() {
        double samples = (double) settings.antialias() * settings.antialias();
        return cluster ? of(samples, "antialias") : new RenderPlan(Method.RAYTRACE, 0, samples, "antialias");
    }

    /**
     * The plan for this many samples per pixel.
     *
     * @param by which part of the budget was decisive
     */
    RenderPlan of(double samples, String by) {
        return isSurveyed(samples)
                ? new RenderPlan(Method.CLUSTER, effort(samples), samples, by)
                : new RenderPlan(Method.RAYTRACE, Math.max(samples, 1), samples, by);
    }

    /** Whether the method of the settings itself can be given so few samples. */
    boolean isPossible(double samples) {
        return samples >= (cluster ? FEWEST_OF_CLUSTER : 1);
    }

    /** Whether with this many samples the picture is surveyed first. */
    boolean isSurveyed(double samples) {
        return cluster && samples >= FEWEST_OF_CLUSTER;
    }

    /** Works out now what all plans with a survey have in common. */
    void prepareSurveyed() {
        cost();
    }

    /** What it costs to know the effort of another number of samples, at most, in rays per pixel of what is rendered. */
    double planningRays() {
        RenderSettings.Crop region = settings.region();
        double surveyed = Math.min((double) settings.width() * settings.height(), COST_BLOCKS * PIXELS_OF_BLOCK);
        return SURVEY_RAYS * surveyed / ((double) region.width() * region.height());
    }

    /** Kept: what was worked out for a trial need not be worked out again for the render. */
    private double effort(double samples) {
        return efforts.computeIfAbsent(samples, n -> cost().effort(n));
    }

    private ClusterCost cost() {
        if (cost == null) {
            cost = ClusterCost.of(scene, settings, COST_BLOCKS, cancelled);
        }
        return cost;
    }
}

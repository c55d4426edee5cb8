package enlightenment.plan;

import enlightenment.classic.cluster.ClusterCost;
import enlightenment.film.FilmTile;
import enlightenment.method.cluster.EffortCost;
import enlightenment.method.cluster.PhysicalClusterCost;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;

/** Efforts of a method that surveys the picture: what they cost is learned from the surveys of some blocks. */
final class EffortLevels implements Levels {
    /** Blocks that are surveyed to learn what an effort costs. */
    private static final int COST_BLOCKS = 512;

    private static final double PIXELS_OF_BLOCK = FilmTile.BLOCK_SIDE * FilmTile.BLOCK_SIDE;

    /** Rays of a survey per pixel: one at each corner of a block's pixels. */
    private static final double SURVEY_RAYS = (FilmTile.BLOCK_SIDE + 1) * (FilmTile.BLOCK_SIDE + 1) / PIXELS_OF_BLOCK;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final boolean reusesLight;
    private final BooleanSupplier cancelled;
    private final Map<Double, Double> efforts = new HashMap<>();
    private EffortCost cost;

    /**
     * @param reusesLight whether light subpaths are reused, too, of physical shading
     */
    EffortLevels(CompiledScene scene, RenderSettings settings, boolean reusesLight, BooleanSupplier cancelled) {
        this.reusesLight = reusesLight;
        this.scene = scene;
        this.settings = settings;
        this.cancelled = cancelled;
    }

    /** Kept: what was worked out for a trial need not be worked out again for the render. */
    @Override
    public double of(double samples) {
        return efforts.computeIfAbsent(samples, n -> cost().effort(n));
    }

    @Override
    public void prepare() {
        cost();
    }

    @Override
    public double planningRays() {
        RenderSettings.Crop region = settings.region();
        double surveyed = Math.min((double) settings.width() * settings.height(), COST_BLOCKS * PIXELS_OF_BLOCK);
        return SURVEY_RAYS * surveyed / ((double) region.width() * region.height());
    }

    private EffortCost cost() {
        if (cost == null) {
            cost = scene.physical == null
                    ? ClusterCost.of(scene, settings, COST_BLOCKS, cancelled)
                    : new PhysicalClusterCost(scene, settings, reusesLight, cancelled);
        }
        return cost;
    }
}

package enlightenment.engine;

import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import java.util.List;

/**
 * What is needed to put the tiles of a render together and to report on it, without the scene.
 *
 * @param sceneName the scene's name
 * @param settings the settings in force
 * @param plan what was decided before the first tile
 * @param features what is modelled, in plain words
 * @param kinds the kinds of primitives in the scene, in the order of their counters
 */
public record RenderOutline(
        String sceneName, RenderSettings settings, RenderPlan plan, List<String> features, List<String> kinds) {
    public RenderOutline {
        features = List.copyOf(features);
        kinds = List.copyOf(kinds);
    }

    /** Number of tiles of the render. */
    public int tiles() {
        return new ColumnGrid(settings, plan).tiles();
    }
}

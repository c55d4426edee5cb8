package enlightenment.render;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.TileMethod;
import enlightenment.method.cluster.ClusterMethod;
import enlightenment.method.cluster.ClusterRecord;
import enlightenment.sampling.Distribution;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.function.Consumer;

/**
 * What is decided about a render before its first tile: with it, a tile is a pure function of scene, settings and place. It is
 * a pure function of scene and settings itself, except that a time budget looks at the clock.
 *
 * @param method what makes the samples: that of the settings, or {@code raytrace} where {@code cluster} has too few of them to
 *     survey the picture first
 * @param level how much is spent. For {@code raytrace} the mean number of samples per pixel, or 0 for antialias²; for
 *     {@code cluster} the effort, the inverse of the variance that is worth one more sample
 * @param samples the mean number of camera rays per pixel that this is expected to take; as a budget of so many samples it
 *     leads to the same plan
 * @param decidedBy which part of the budget was decisive: antialias, samples, error or time
 */
public record RenderPlan(Method method, double level, double samples, String decidedBy) {
    /** The method, for one thread. */
    TileMethod method(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return method(scene, settings, counters, null);
    }

    /**
     * The method, for one thread.
     *
     * @param clusters is shown the ray clusters of each block, if the method has any; null for nobody
     */
    TileMethod method(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            Consumer<List<ClusterRecord>> clusters) {
        if (method == Method.CLUSTER) {
            return new ClusterMethod(
                    scene, settings, counters, Distribution.of(settings.proposal()), level, samples, clusters);
        }
        return level == 0
                ? new RayTraceMethod(scene, settings, counters)
                : RayTraceMethod.withMeanSamples(scene, settings, counters, level);
    }
}

package enlightenment.plan;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.math.InvalidValueException;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.TileMethod;
import enlightenment.method.cluster.ClusterMethod;
import enlightenment.method.cluster.ClusterStatistics;
import enlightenment.sampling.Distribution;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ClusterSettings;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.function.Consumer;

/** Makes what renders tiles: the one place that knows the class behind each method. */
public final class TileMethods {
    private TileMethods() {}

    /** The planned method, for one thread. */
    public static TileMethod of(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return of(plan, scene, settings, counters, null);
    }

    /**
     * The planned method, for one thread.
     *
     * @param clusters is shown the ray clusters of each block, if the method has any; null for nobody
     */
    public static TileMethod of(
            RenderPlan plan,
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            Consumer<List<ClusterStatistics>> clusters) {
        if (!(plan.method() instanceof BuiltInMethod method)) {
            throw new InvalidValueException(
                    "method",
                    "has no class behind it that renders tiles: "
                            + plan.method().word());
        }
        return switch (method) {
            case RAYTRACE ->
                plan.level() == 0
                        ? new RayTraceMethod(scene, settings, counters)
                        : RayTraceMethod.withMeanSamples(scene, settings, counters, plan.level());
            case CLUSTER ->
                new ClusterMethod(
                        scene,
                        settings,
                        counters,
                        Distribution.of(ClusterSettings.of(settings).proposal()),
                        plan.level(),
                        plan.samples(),
                        clusters);
        };
    }
}

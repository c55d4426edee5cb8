package enlightenment.plan;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.method.Integrator;
import enlightenment.scene.RenderSettings;

/** What a {@link enlightenment.scene.MethodExtension} implements, too, so that there is something that does its work. */
public interface IntegratorFactory {
    /**
     * Makes what does the work of the method, for one thread: a {@link enlightenment.method.TileIntegrator} or a {@link
     * enlightenment.method.SplatIntegrator}, as its {@linkplain enlightenment.scene.Method#kind kind} says.
     *
     * @param plan its level is the number of samples per pixel
     * @param counters what is counted is to be added to these
     */
    Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters);

    /** What {@link enlightenment.method.TileIntegrator#dividesIntoPasses} says of all that it makes. */
    default boolean dividesIntoPasses() {
        return false;
    }
}

package enlightenment.plan;

import enlightenment.method.Integrator;
import enlightenment.method.SplatIntegrator;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

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

    /**
     * How many paths that may end anywhere are splatted over what its tiles make, per camera sample of the whole picture: for light
     * that is found better from elsewhere than from the eye. A function of scene and settings. 0, as here: none. Only of a method
     * whose {@linkplain enlightenment.scene.Method#kind kind} is tiles.
     */
    default double lightPathsPerSample(CompiledScene scene, RenderSettings settings) {
        return 0;
    }

    /**
     * Makes what follows these paths, for one thread.
     *
     * @param plan has some of them
     * @param counters what is counted is to be added to these
     */
    default SplatIntegrator makeLightPaths(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        throw new UnsupportedOperationException("it has no light paths");
    }
}

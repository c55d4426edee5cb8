package enlightenment.plan;

import enlightenment.method.Integrator;
import enlightenment.method.SplatIntegrator;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;

/** Makes the integrators of a method. A {@link enlightenment.scene.MethodExtension} must implement it, too. */
public interface IntegratorFactory {
    /**
     * Makes an integrator of the method for one thread. It is a {@link enlightenment.method.TileIntegrator} or a
     * {@link enlightenment.method.SplatIntegrator}, as its {@linkplain enlightenment.scene.Method#kind kind} says.
     *
     * @param plan its level is the number of samples per pixel
     * @param counters the integrator adds its counts to these
     */
    Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters);

    /** The value of {@link enlightenment.method.TileIntegrator#dividesIntoPasses} of all integrators made here. */
    default boolean dividesIntoPasses() {
        return false;
    }

    /**
     * The number of light paths that are splatted over its tiles, per camera sample of the whole picture. They sample light that is found
     * better from elsewhere than from the eye. A function of scene and settings. 0, as here: none. Only of a method whose
     * {@linkplain enlightenment.scene.Method#kind kind} is tiles.
     */
    default double lightPathsPerSample(CompiledScene scene, RenderSettings settings) {
        return 0;
    }

    /**
     * Makes the integrator of these paths for one thread.
     *
     * @param plan has some of them
     * @param counters the integrator adds its counts to these
     */
    default SplatIntegrator makeLightPaths(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        throw new UnsupportedOperationException("it has no light paths");
    }
}

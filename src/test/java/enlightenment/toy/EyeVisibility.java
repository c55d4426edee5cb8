package enlightenment.toy;

import enlightenment.method.Integrator;
import enlightenment.plan.IntegratorFactory;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.MethodExtension;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Set;

/**
 * The example of a method that splats, in tests only: points on the scene's balls look for the eye. A perspective camera sees all balls
 * white, and everything else black.
 */
public final class EyeVisibility extends MethodExtension implements IntegratorFactory {
    public static final String WORD = "eye-visibility";

    /** Found as a service. */
    public EyeVisibility() {
        super(
                WORD,
                "points on the balls of the scene that look for the eye",
                Kind.SPLATS,
                Set.of(Shading.Model.CLASSIC),
                List.of());
    }

    @Override
    public Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new EyeVisibilityIntegrator(scene, settings, counters, 1);
    }
}

package enlightenment.toy;

import enlightenment.method.Integrator;
import enlightenment.method.RayTraceMethod;
import enlightenment.plan.IntegratorFactory;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.Method;
import enlightenment.scene.MethodExtension;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Set;

/**
 * The example of a method with a shader of its own, in tests only: evenly spaced camera rays, each of them worth the share of the
 * hemisphere, weighted by the cosine, in which nothing is above the surface that it meets.
 */
public final class AmbientOcclusion extends MethodExtension implements IntegratorFactory {
    public static final String WORD = "ambient-occlusion";
    static final Method.Setting.Whole RAYS =
            new Method.Setting.Whole("occlusionRays", 1, 1024, 4, "rays into the hemisphere of each hit");

    /** Found as a service. */
    public AmbientOcclusion() {
        super(
                WORD,
                "evenly spaced camera rays, each worth how open the sky is above what it meets",
                Kind.TILES,
                Set.of(Shading.Model.CLASSIC),
                List.of(RAYS));
    }

    @Override
    public Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        int rays = settings.chosen().whole(RAYS);
        return new RayTraceMethod(scene, settings, new AmbientOcclusionShader(scene, rays, counters), plan.level());
    }

    @Override
    public boolean dividesIntoPasses() {
        return true;
    }

    /** Its settings. */
    public record Settings(int rays) implements Method.Settings {
        @Override
        public Method method() {
            return Method.named(WORD);
        }

        @Override
        public Object value(Method.Setting setting) {
            return rays;
        }
    }
}

package enlightenment.toy;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.method.Integrator;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.SplatIntegrator;
import enlightenment.plan.IntegratorFactory;
import enlightenment.plan.RenderPlan;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.scene.MethodExtension;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Shading;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;

/**
 * The example of a method that does both, in tests only: half of the light of white balls comes by camera rays, half by points on the
 * balls that look for the eye. Together they are what {@code raytrace} sees.
 */
public final class HalfAndHalf extends MethodExtension implements IntegratorFactory {
    public static final String WORD = "half-and-half";

    /** Found as a service. */
    public HalfAndHalf() {
        super(
                WORD,
                "half the light of white balls by camera rays, half by points on the balls that look for the eye",
                Kind.TILES,
                Set.of(Shading.Model.CLASSIC),
                List.of());
    }

    @Override
    public Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        Shader whole = ClassicShader.ofColors(scene, 1, counters);
        return new RayTraceMethod(scene, settings, new HalfShader(whole), plan.level());
    }

    @Override
    public boolean dividesIntoPasses() {
        return true;
    }

    @Override
    public double lightPathsPerSample(CompiledScene scene, RenderSettings settings) {
        return 0.5;
    }

    @Override
    public SplatIntegrator makeLightPaths(
            RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new EyeVisibilityIntegrator(scene, settings, counters, 0.5);
    }

    /** Half of what another shader says. */
    private record HalfShader(Shader whole) implements Shader {
        @Override
        public void beginTile(double x0, double y0, double x1, double y1) {
            whole.beginTile(x0, y0, x1, y1);
        }

        @Override
        public boolean seesNothing() {
            return whole.seesNothing();
        }

        @Override
        public void stopWhen(BooleanSupplier condition) {
            whole.stopWhen(condition);
        }

        @Override
        public void shade(Ray ray, Sampler sampler, double[] out) {
            whole.shade(ray, sampler, out);
            for (int c = 0; c < 3; c++) {
                out[c] /= 2;
            }
        }
    }
}

package enlightenment.scene;

import enlightenment.method.Integrator;
import enlightenment.plan.IntegratorFactory;
import enlightenment.plan.RenderPlan;
import enlightenment.plan.ToySplats;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Set;

/** A method that is in the tests only: the program finds it as a service, and nothing in the program names it. */
public final class ToyMethod extends MethodExtension implements IntegratorFactory {
    public static final String WORD = "toy";
    public static final Method.Setting.Whole RAYS =
            new Method.Setting.Whole("toyRays", 1, 64, 8, "rays of the toy per hit");
    public static final Method.Setting.Word SHAPE =
            new Method.Setting.Word("toyShape", List.of("round", "square"), "shape of what the toy looks at");

    public ToyMethod() {
        super(
                WORD,
                "a toy that only the tests have",
                Kind.SPLATS,
                Set.of(Shading.Model.CLASSIC, Shading.Model.PHYSICAL),
                List.of(RAYS, SHAPE));
    }

    @Override
    public Integrator make(RenderPlan plan, CompiledScene scene, RenderSettings settings, RayCounters counters) {
        return new ToySplats(scene, settings, counters);
    }

    /** Its settings. */
    public record Settings(int rays, String shape) implements Method.Settings {
        public static Settings of(RenderSettings settings) {
            return new Settings(settings.chosen().whole(RAYS), settings.chosen().word(SHAPE));
        }

        @Override
        public Method method() {
            return Method.named(WORD);
        }

        @Override
        public Object value(Method.Setting setting) {
            return setting.equals(RAYS) ? (Object) rays : shape;
        }
    }
}

package enlightenment.engine;

import enlightenment.color.DisplayCurve;
import enlightenment.film.SplatScale;
import enlightenment.method.SplatIntegrator;
import enlightenment.plan.Integrators;
import enlightenment.plan.RenderPlan;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;

/**
 * The data for assembling a render's units and for its report, without the scene.
 *
 * @param sceneName the scene's name
 * @param settings the settings in force
 * @param plan the plan that was decided before the first unit
 * @param features the effects that are modelled, and those that the method cannot sample, in plain words
 * @param kinds the kinds of primitives in the scene, in the order of their counters
 * @param display what pixels are, and how they become what a screen takes
 * @param splatScale the unit in which contributions of paths are summed; of no meaning where no units are batches of paths
 * @param undersampled {@link Integrators#undersampled}
 */
public record RenderOutline(
        String sceneName,
        RenderSettings settings,
        RenderPlan plan,
        List<String> features,
        List<String> kinds,
        DisplayCurve display,
        SplatScale splatScale,
        List<String> undersampled) {
    private static final SplatScale NO_SCALE = new SplatScale(0);

    public RenderOutline {
        features = List.copyOf(features);
        kinds = List.copyOf(kinds);
        undersampled = List.copyOf(undersampled);
    }

    /** An outline for units that are tiles of display-referred pixels. */
    public RenderOutline(
            String sceneName, RenderSettings settings, RenderPlan plan, List<String> features, List<String> kinds) {
        this(sceneName, settings, plan, features, kinds, DisplayCurve.NONE, NO_SCALE, List.of());
    }

    /** The outline of a render of this scene. */
    public static RenderOutline of(String sceneName, CompiledScene scene, RenderSettings settings, RenderPlan plan) {
        List<String> features = new ArrayList<>(scene.features());
        Integrators.blindSpot(settings.method(), scene).ifPresent(features::add);
        RenderOutline outline = new RenderOutline(sceneName, settings, plan, features, scene.kindNames)
                .withDisplay(scene.display)
                .withUndersampled(Integrators.undersampled(plan.method(), scene));
        RayCounters unused = new RayCounters(scene.kindNames.size());
        WorkUnits units = WorkUnits.forMachines(settings, plan);
        if (units.batches() == 0) {
            return outline;
        }
        SplatIntegrator integrator = Integrators.splats(plan, scene, settings, unused);
        long pixels = (long) settings.width() * settings.height();
        return outline.withSplatScale(SplatScale.of(integrator.expectedContribution(), units.paths(), pixels));
    }

    /** This outline with another splat scale. */
    public RenderOutline withSplatScale(SplatScale scale) {
        return new RenderOutline(sceneName, settings, plan, features, kinds, display, scale, undersampled);
    }

    /** This outline with another display curve. */
    public RenderOutline withDisplay(DisplayCurve curve) {
        return new RenderOutline(sceneName, settings, plan, features, kinds, curve, splatScale, undersampled);
    }

    /** This outline with another list of undersampled transport. */
    public RenderOutline withUndersampled(List<String> transport) {
        return new RenderOutline(sceneName, settings, plan, features, kinds, display, splatScale, transport);
    }

    /** Number of units of work, as they are handed out to many machines. */
    public int units() {
        return WorkUnits.forMachines(settings, plan).count();
    }
}

package enlightenment.plan;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.method.TileIntegrator;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;

/** Renders some blocks with random numbers that are not the picture's: nothing may depend on what it is decided about. */
final class Trial {
    /** Keeps the trial's random numbers apart from the picture's. */
    private static final long PURPOSE = 0x747269616cL;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final SamplePlans plans;

    Trial(CompiledScene scene, RenderSettings settings, SamplePlans plans) {
        this.scene = scene;
        this.settings = settings.withSeed(Hash.of(settings.seed(), PURPOSE));
        this.plans = plans;
    }

    /** Renders these blocks with this many samples per pixel, unless it is stopped. */
    void render(double samples, List<FilmTile> blocks, BooleanSupplier stop) {
        RenderPlan plan = plans.of(samples, "trial");
        Workers.run(settings.threads(), blocks.size(), stop, () -> {
            TileIntegrator method =
                    (TileIntegrator) Integrators.of(plan, scene, settings, new RayCounters(scene.kindNames.size()));
            method.stopWhen(stop);
            return (IntConsumer) i -> method.render(blocks.get(i));
        });
    }
}

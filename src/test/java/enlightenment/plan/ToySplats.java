package enlightenment.plan;

import enlightenment.film.SplatBatch;
import enlightenment.method.SplatIntegrator;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.parts.RayCounters;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * What the toy method does: a path begins at a point of the picture that chance chooses, brings white where an object is seen there,
 * and somewhere else a third of what is left: so each path reaches two points.
 */
public final class ToySplats implements SplatIntegrator {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RayCounters counters;
    private final Tracer tracer;
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private BooleanSupplier cancelled = () -> false;

    public ToySplats(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        this.scene = scene;
        this.settings = settings;
        this.counters = counters;
        tracer = new Tracer(scene, counters);
    }

    @Override
    public void stopWhen(BooleanSupplier stop) {
        cancelled = stop;
    }

    @Override
    public double expectedContribution() {
        return 1;
    }

    @Override
    public void trace(long firstPath, int paths, SplatBatch out) {
        for (int i = 0; i < paths; i++) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException();
            }
            trace(Hash.of(settings.seed(), firstPath + i), out);
        }
    }

    private void trace(long path, SplatBatch out) {
        double u = Hash.unit(Hash.of(path, 1));
        double v = Hash.unit(Hash.of(path, 2));
        scene.camera.ray(u, v, ray);
        counters.cameraRays++;
        double bright = tracer.trace(ray, hit) ? 1 : 0.25;
        out.add(u * settings.width(), v * settings.height(), bright, bright, u);
        double other = Hash.unit(Hash.of(path, 3));
        out.add(other * settings.width(), v * settings.height(), (1 - bright) / 3, v, 0);
    }
}

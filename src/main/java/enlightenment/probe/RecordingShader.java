package enlightenment.probe;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.film.SampleLog;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.sampling.SobolSampler;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * Another shader, of whose samples a log is kept: colours are the same to the bit. For methods that sample pixels by {@link SobolSampler}.
 */
public final class RecordingShader implements Shader {
    private final Shader shader;
    private final SampleLog log;

    /** Null if rays are not asked for. */
    private final RayProbe probe;

    private RecordingShader(Shader shader, SampleLog log, RayProbe probe) {
        this.shader = shader;
        this.log = log;
        this.probe = probe;
    }

    /**
     * A shader of the scene's shading, for one thread.
     *
     * @param lightPoints of classic shading, the number of points of each light at each hit
     * @param counters what this thread counts, of what is shaded
     */
    public static RecordingShader of(CompiledScene scene, int lightPoints, RayCounters counters, SampleLog log) {
        if (scene.physical != null) {
            Shader shader = new PathIntegrator(scene, counters);
            return new RecordingShader(shader, log, log.hasRays() ? new PhysicalProbe(scene) : null);
        }
        if (!log.hasRays()) {
            return new RecordingShader(ClassicShader.ofColors(scene, lightPoints, counters), log, null);
        }
        ClassicShader shader = new ClassicShader(scene, lightPoints, counters);
        shader.report().keepRays();
        return new RecordingShader(shader, log, new ClassicProbe(scene, shader.report()));
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        shader.beginTile(x0, y0, x1, y1);
        if (probe != null) {
            probe.beginTile(x0, y0, x1, y1);
        }
    }

    @Override
    public boolean seesNothing() {
        return shader.seesNothing();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        shader.stopWhen(condition);
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        if (probe != null) {
            probe.begin(ray);
        }
        shader.shade(ray, sampler, out);
        SobolSampler pixel = (SobolSampler) sampler;
        log.add(pixel.column(), pixel.row(), pixel.filmX(), pixel.filmY(), out);
        if (probe != null) {
            probe.tell(pixel);
            log.ray(probe.points, probe.outcome, probe.bounces);
        }
    }
}

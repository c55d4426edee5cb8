package enlightenment.toy;

import enlightenment.bsdf.Lambert;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.parts.RayCounters;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * How open the sky is above the surface that a camera ray meets: ∫ V(ω) cosθ/π dω, with directions sampled proportionally to cosθ. What
 * meets nothing is white. Lights are seen through.
 */
final class AmbientOcclusionShader implements Shader {
    private final int rays;
    private final RayCounters counters;
    private final Tracer tracer;
    private final Hit hit = new Hit();
    private final Hit above = new Hit();
    private final Ray up = new Ray();
    private final Scattering scattering = new Scattering();
    private final double[] point = new double[2];
    private BooleanSupplier cancelled = () -> false;

    AmbientOcclusionShader(CompiledScene scene, int rays, RayCounters counters) {
        this.rays = rays;
        this.counters = counters;
        tracer = new Tracer(scene, counters);
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        tracer.beginTile(x0, y0, x1, y1);
    }

    @Override
    public boolean seesNothing() {
        return tracer.seesNothing();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        cancelled = condition;
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
        counters.cameraRays++;
        double open = 1;
        if (tracer.traceCamera(ray, hit) && tracer.light == null) {
            int free = 0;
            for (int k = 0; k < rays; k++) {
                sampler.pair(k, Sampler.Purpose.DIRECTION, point);
                free += isOpen(point[0], point[1]) ? 1 : 0;
            }
            open = (double) free / rays;
        }
        out[0] = open;
        out[1] = open;
        out[2] = open;
    }

    private boolean isOpen(double u, double v) {
        scattering.nx = hit.nx * hit.side;
        scattering.ny = hit.ny * hit.side;
        scattering.nz = hit.nz * hit.side;
        if (!Lambert.INSTANCE.sample(scattering, u, v, 0)) {
            return false;
        }
        up.set(hit.px, hit.py, hit.pz, scattering.ix, scattering.iy, scattering.iz, 0)
                .from(hit.primitive, hit.side);
        return !tracer.trace(up, above) || tracer.light != null;
    }
}

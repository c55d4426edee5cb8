package enlightenment.method;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/** Camera samples while the shutter is open: each sees one of the scene's moments ({@link Moments}). */
final class Exposure {
    private final CompiledScene[] moments;
    private final Shader[] shaders;
    private final Moments lots;
    private long pixelHash;

    /**
     * @param shader makes the shader of a moment
     */
    Exposure(CompiledScene[] moments, Function<CompiledScene, Shader> shader) {
        this.moments = moments;
        shaders = new Shader[moments.length];
        for (int i = 0; i < moments.length; i++) {
            shaders[i] = shader.apply(moments[i]);
        }
        lots = new Moments(moments.length);
    }

    void stopWhen(BooleanSupplier cancelled) {
        for (Shader shader : shaders) {
            shader.stopWhen(cancelled);
        }
    }

    void beginTile(double x0, double y0, double x1, double y1) {
        for (Shader shader : shaders) {
            shader.beginTile(x0, y0, x1, y1);
        }
    }

    void pixel(long seed, int x, int y) {
        pixelHash = Hash.of(Hash.of(seed, Moments.PURPOSE), x, y);
    }

    /** The index of the moment that this sample of the current pixel sees. */
    int moment(int sample) {
        return lots.of(pixelHash, sample);
    }

    /** As {@link Shader#shade}, for a sample at a film position (u, v) in 0..1. */
    void shade(int sample, double u, double v, Ray ray, Sampler sampler, double[] out) {
        int moment = moment(sample);
        moments[moment].camera.ray(u, v, sampler, ray);
        shaders[moment].shade(ray, sampler, out);
    }
}

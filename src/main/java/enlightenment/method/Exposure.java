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
    private final MomentShaders shaders;
    private final Moments lots;
    private long pixelHash;

    /**
     * @param shader makes the shader of a moment
     */
    Exposure(CompiledScene[] moments, Function<CompiledScene, Shader> shader) {
        shaders = new MomentShaders(moments, shader);
        lots = new Moments(moments.length);
    }

    void stopWhen(BooleanSupplier cancelled) {
        shaders.stopWhen(cancelled);
    }

    void beginTile(double x0, double y0, double x1, double y1) {
        shaders.beginTile(x0, y0, x1, y1);
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
        shaders.shade(moment(sample), u, v, ray, sampler, out);
    }
}

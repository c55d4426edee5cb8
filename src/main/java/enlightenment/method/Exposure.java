package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.shading.Shader;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/**
 * Which of a scene's moments a camera sample sees while the shutter is open. Of the samples of a pixel, each block of as many as there
 * are moments sees every moment once; blocks begin at moments that are drawn by lot, and so do pixels. Neighbours in a block are far
 * apart in time, so that a part of a block is spread over it.
 */
final class Exposure {
    /** Tells these lots from those of the sampler. */
    private static final long PURPOSE = 0x5348555454455221L;

    /** What neighbours in a block are apart: the golden section leaves the most even gaps, however many there are. */
    private static final double STEP = (Math.sqrt(5) - 1) / 2;

    private final CompiledScene[] moments;
    private final Shader[] shaders;
    private final int step;
    private long pixelHash;

    /** @param shader makes what a ray of a moment is worth */
    Exposure(CompiledScene[] moments, Function<CompiledScene, Shader> shader) {
        this.moments = moments;
        shaders = new Shader[moments.length];
        for (int i = 0; i < moments.length; i++) {
            shaders[i] = shader.apply(moments[i]);
        }
        step = step(moments.length);
    }

    /** The number next below the golden section of a number that has no divisor in common with it. */
    static int step(int count) {
        int step = Math.max((int) (STEP * count), 1);
        while (greatestCommonDivisor(step, count) > 1) {
            step--;
        }
        return step;
    }

    private static int greatestCommonDivisor(int a, int b) {
        return b == 0 ? a : greatestCommonDivisor(b, a % b);
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
        pixelHash = Hash.of(Hash.of(seed, PURPOSE), x, y);
    }

    /** The index of the moment that a sample of the pixel sees. */
    int moment(int sample) {
        int count = moments.length;
        long lot = Long.remainderUnsigned(Hash.next(pixelHash, sample / count), count);
        return (int) ((lot + (long) (sample % count) * step) % count);
    }

    /** As {@link Shader#shade}, of a sample at a place of the picture, 0..1. */
    void shade(int sample, double u, double v, Ray ray, Sampler sampler, double[] out) {
        int moment = moment(sample);
        moments[moment].camera.ray(u, v, ray);
        shaders[moment].shade(ray, sampler, out);
    }
}

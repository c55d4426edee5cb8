package enlightenment.method;

import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/** A shader for each moment that samples see while the shutter is open. One per thread. */
public final class MomentShaders {
    private final CompiledScene[] moments;
    private final Shader[] shaders;

    /**
     * @param moments at least one
     * @param shader makes the shader of a moment
     */
    public MomentShaders(CompiledScene[] moments, Function<CompiledScene, Shader> shader) {
        this.moments = moments;
        shaders = new Shader[moments.length];
        Arrays.setAll(shaders, i -> shader.apply(moments[i]));
    }

    /** The number of moments. */
    public int count() {
        return moments.length;
    }

    /** Stops all shaders where this becomes true ({@link Shader#stopWhen}). */
    public void stopWhen(BooleanSupplier cancelled) {
        for (Shader shader : shaders) {
            shader.stopWhen(cancelled);
        }
    }

    /** Turns all shaders to a tile ({@link Shader#beginTile}). */
    public void beginTile(double x0, double y0, double x1, double y1) {
        for (Shader shader : shaders) {
            shader.beginTile(x0, y0, x1, y1);
        }
    }

    /**
     * Shades a camera ray of a moment ({@link Shader#shade}).
     *
     * @param moment its index
     * @param u position in the picture, 0..1 from the left
     * @param v position in the picture, 0..1 from above
     * @param ray is overwritten
     */
    public void shade(int moment, double u, double v, Ray ray, Sampler sampler, double[] out) {
        moments[moment].camera.ray(u, v, sampler, ray);
        shaders[moment].shade(ray, sampler, out);
    }
}

package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.Shader;
import java.util.function.BooleanSupplier;

/**
 * Evenly spaced camera rays, the paper's first phase: well-distributed positions in every pixel, each of them shaded once;
 * antialias² of them unless a budget says how many.
 */
public final class RayTraceMethod implements TileMethod {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final Shader shader;
    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    /** Samples of the pixels that get fewer; others get twice as many. */
    private final int fewer;

    /** The share of pixels that get twice as many. */
    private final double doubled;

    /** Takes antialias² samples in each pixel. */
    public RayTraceMethod(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        this(scene, settings, Shader.of(scene, settings.shadowSamples(), counters));
    }

    /** The same with another shader than the scene's own. */
    public RayTraceMethod(CompiledScene scene, RenderSettings settings, Shader shader) {
        this(scene, settings, shader, settings.antialias() * settings.antialias(), 0);
    }

    private RayTraceMethod(CompiledScene scene, RenderSettings settings, Shader shader, int fewer, double doubled) {
        this.scene = scene;
        this.settings = settings;
        this.shader = shader;
        this.fewer = fewer;
        this.doubled = doubled;
    }

    /**
     * Takes this many samples per pixel in the mean, at least 1: the next power of two below in some pixels and that above in
     * the others, since these are the numbers for which the points are best distributed.
     */
    public static RayTraceMethod withMeanSamples(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        int fewer = Integer.highestOneBit((int) samples);
        Shader shader = Shader.of(scene, settings.shadowSamples(), counters);
        return new RayTraceMethod(scene, settings, shader, fewer, samples / fewer - 1);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        shader.stopWhen(cancelled);
    }

    @Override
    public void render(FilmTile tile) {
        double width = settings.width();
        double height = settings.height();
        shader.beginTile(
                tile.x / width, tile.y / height, (tile.x + tile.width) / width, (tile.y + tile.height) / height);
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                renderPixel(tile, x, y);
            }
        }
    }

    private void renderPixel(FilmTile tile, int x, int y) {
        sampler.pixel(settings.seed(), x, y);
        int samples = Dither.at(x, y) < doubled ? 2 * fewer : fewer;
        spread.begin(samples);
        for (int s = 0; s < samples; s++) {
            sampler.sample(s);
            double dx = sampler.filmX();
            double dy = sampler.filmY();
            scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), ray);
            shader.shade(ray, sampler, color);
            tile.add(x, y, color[0], color[1], color[2]);
            spread.at(dx, dy);
            spread.add(color[0], color[1], color[2]);
        }
        tile.spread(x, y, spread);
    }
}

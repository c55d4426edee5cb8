package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.film.TilePasses;
import enlightenment.primitive.Ray;
import enlightenment.scene.RayTraceSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.ClassicShader;
import enlightenment.shading.SampleAddress;
import java.util.function.BooleanSupplier;

/**
 * Evenly spaced camera rays, the paper's first phase: well-distributed positions in every pixel, each of them shaded once;
 * antialias² of them unless a budget says how many.
 */
public final class RayTraceMethod implements TileIntegrator {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final ClassicShader shader;
    private final Ray ray = new Ray();
    private final SampleAddress address = new SampleAddress();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    /** Samples of the pixels that get fewer; others get twice as many. */
    private final int fewer;

    /** The share of pixels that get twice as many. */
    private final double doubled;

    /** Takes antialias² samples in each pixel. */
    public RayTraceMethod(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        this(scene, settings, counters, settings.antialias() * settings.antialias(), 0);
    }

    private RayTraceMethod(
            CompiledScene scene, RenderSettings settings, RayCounters counters, int fewer, double doubled) {
        this.scene = scene;
        this.settings = settings;
        this.shader = new ClassicShader(scene, RayTraceSettings.of(settings).shadowSamples(), counters);
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
        return new RayTraceMethod(scene, settings, counters, fewer, samples / fewer - 1);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        shader.stopWhen(cancelled);
    }

    @Override
    public boolean dividesIntoPasses() {
        return true;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.check(pass, passes, fewer);
        double width = settings.width();
        double height = settings.height();
        shader.beginTile(
                tile.x / width, tile.y / height, (tile.x + tile.width) / width, (tile.y + tile.height) / height);
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                renderPixel(tile, x, y, pass, passes);
            }
        }
    }

    private void renderPixel(FilmTile tile, int x, int y, int pass, int passes) {
        address.pixel(settings.seed(), x, y);
        int samples = Dither.at(x, y) < doubled ? 2 * fewer : fewer;
        if (passes > 1) {
            int end = TilePasses.firstSample(samples, pass + 1, passes);
            for (int s = TilePasses.firstSample(samples, pass, passes); s < end; s++) {
                sample(tile, x, y, s);
            }
            return;
        }
        spread.begin(samples);
        for (int s = 0; s < samples; s++) {
            sample(tile, x, y, s);
            spread.at(address.filmX(), address.filmY());
            spread.add(color[0], color[1], color[2]);
        }
        tile.spread(x, y, spread);
    }

    private void sample(FilmTile tile, int x, int y, int index) {
        address.sample(index);
        double dx = address.filmX();
        double dy = address.filmY();
        scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), ray);
        shader.shade(ray, address, color);
        tile.add(x, y, color[0], color[1], color[2]);
    }
}

package enlightenment.method;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.RayCounters;
import enlightenment.film.FilmTile;
import enlightenment.geometry.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.shading.ClassicShader;
import enlightenment.shading.SampleAddress;

/**
 * Evenly spaced camera rays, the paper's first phase: antialias² well-distributed positions in every pixel, each of them
 * shaded once. One per thread; a tile is a pure function of scene, settings and tile.
 */
public final class RayTraceMethod {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final ClassicShader shader;
    private final Ray ray = new Ray();
    private final SampleAddress address = new SampleAddress();
    private final double[] color = new double[3];

    public RayTraceMethod(CompiledScene scene, RenderSettings settings, RayCounters counters) {
        this.scene = scene;
        this.settings = settings;
        this.shader = new ClassicShader(scene, settings.shadowSamples(), counters);
    }

    /** Renders the pixels of a tile. */
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
        address.pixel(settings.seed(), x, y);
        int samples = settings.antialias() * settings.antialias();
        for (int s = 0; s < samples; s++) {
            address.sample(s);
            double filmX = (x + address.filmX()) / settings.width();
            double filmY = (y + address.filmY()) / settings.height();
            scene.camera.ray(filmX, filmY, ray);
            shader.shade(ray, address, color);
            tile.add(x, y, color[0], color[1], color[2]);
        }
    }
}

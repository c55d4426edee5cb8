package enlightenment.method;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleLog;
import enlightenment.film.SampleSpread;
import enlightenment.film.TileGrowth;
import enlightenment.film.TilePasses;
import enlightenment.primitive.Ray;
import enlightenment.probe.RecordingShader;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.path.SeenLight;
import enlightenment.transport.ray.Shader;
import enlightenment.transport.state.PathPart;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.BiFunction;
import java.util.function.BooleanSupplier;
import java.util.function.Function;

/**
 * Evenly spaced camera rays, the paper's first phase: well-distributed positions in every pixel, each of them shaded once;
 * antialias² of them unless a budget says how many.
 */
public final class RayTraceMethod implements TileIntegrator {
    private final CompiledScene scene;
    private final RenderSettings settings;
    /** Shades one sample after the other; null if {@link #tiles} does it. */
    private final Shader shader;

    /** Shades the samples of a tile; null if they are shaded one by one. */
    private final TileShader tiles;

    /** Which moment a sample sees; null if all see the same. */
    private final Exposure exposure;

    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    /** Where in its pixel the last sample is. */
    private double dx;

    private double dy;

    /** Samples of the pixels that get fewer; others get twice as many. */
    private final int fewer;

    /** The share of pixels that get twice as many. */
    private final double doubled;

    /**
     * Takes this many samples per pixel in the mean: the next power of two below in some pixels and that above in the others,
     * since these are the numbers for which the points are best distributed.
     *
     * @param scene has no instants, or is rendered at the time of its frame
     * @param shader what each of the rays is worth
     * @param samples at least 1; or 0 for antialias² samples in each pixel
     */
    public RayTraceMethod(CompiledScene scene, RenderSettings settings, Shader shader, double samples) {
        this(scene, settings, shader, null, null, samples);
    }

    private RayTraceMethod(
            CompiledScene scene,
            RenderSettings settings,
            Shader shader,
            TileShader tiles,
            Exposure exposure,
            double samples) {
        this.scene = scene;
        this.settings = settings;
        this.shader = shader;
        this.tiles = tiles;
        this.exposure = exposure;
        fewer = samples == 0 ? settings.antialias() * settings.antialias() : Integer.highestOneBit((int) samples);
        doubled = samples == 0 ? 0 : samples / fewer - 1;
    }

    /** The same with the scene's shading. */
    public static RayTraceMethod of(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        int lightPoints = BuiltInMethod.RayTraceSettings.of(settings).shadowSamples();
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> moment.physical != null
                        ? new PathIntegrator(moment, counted)
                        : ClassicShader.ofColors(moment, lightPoints, counted));
    }

    /** The same, of whose samples a log is kept. */
    public static RayTraceMethod recorded(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples, SampleLog log) {
        int lightPoints = BuiltInMethod.RayTraceSettings.of(settings).shadowSamples();
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> RecordingShader.of(moment, lightPoints, counted, log));
    }

    /** The same with a shader of each moment. */
    static RayTraceMethod of(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            double samples,
            BiFunction<CompiledScene, RayCounters, Shader> shader) {
        Function<CompiledScene, Shader> counted = moment -> shader.apply(moment, scene.countersOf(moment, counters));
        Exposure exposure = scene.instants.length == 0 ? null : new Exposure(scene.instants, counted);
        return new RayTraceMethod(scene, settings, counted.apply(scene), null, exposure, samples);
    }

    /** Another shader takes the samples of a whole tile. Tiles that are begun elsewhere do not grow here. */
    public static RayTraceMethod ofTiles(
            CompiledScene scene, RenderSettings settings, double samples, TileShader shader) {
        return new RayTraceMethod(scene, settings, null, shader, null, samples);
    }

    /** Of physical shading, that part of each sample which is direct light: {@link PathPart#DIRECT}. */
    public static RayTraceMethod ofDirectLight(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> new PathIntegrator(moment, counted, PathPart.DIRECT));
    }

    /** Of physical shading, in place of light the reflectance of what is seen: {@link PathPart#ALBEDO}. */
    public static RayTraceMethod ofAlbedo(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> new PathIntegrator(moment, counted, PathPart.ALBEDO));
    }

    /** Of physical shading, that part of each sample which no path from a light can be connected to the eye with: {@link SeenLight}. */
    public static RayTraceMethod ofSeenLight(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return of(scene, settings, counters, samples, SeenLight::new);
    }

    @Override
    public void stopWhen(BooleanSupplier cancelled) {
        if (tiles != null) {
            tiles.stopWhen(cancelled);
            return;
        }
        shader.stopWhen(cancelled);
        if (exposure != null) {
            exposure.stopWhen(cancelled);
        }
    }

    @Override
    public boolean dividesIntoPasses() {
        return true;
    }

    @Override
    public void render(FilmTile tile, int pass, int passes) {
        TilePasses.check(pass, passes, fewer);
        if (tiles == null) {
            begin(tile);
        } else {
            begin(tile, pass, passes);
        }
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                renderPixel(tile, x, y, pass, passes);
            }
        }
    }

    private void begin(FilmTile tile) {
        double width = settings.width();
        double height = settings.height();
        double right = (tile.x + tile.width) / width;
        double bottom = (tile.y + tile.height) / height;
        if (exposure == null) {
            shader.beginTile(tile.x / width, tile.y / height, right, bottom);
        } else {
            exposure.beginTile(tile.x / width, tile.y / height, right, bottom);
        }
    }

    /** Tells which samples are taken of which pixels. */
    private void begin(FilmTile tile, int pass, int passes) {
        int pixels = tile.width * tile.height;
        int[] first = new int[pixels];
        int[] start = new int[pixels + 1];
        for (int k = 0; k < pixels; k++) {
            int samples = samplesOf(tile.x + k % tile.width, tile.y + k / tile.width);
            first[k] = TilePasses.firstSample(samples, pass, passes);
            start[k + 1] = start[k] + TilePasses.firstSample(samples, pass + 1, passes) - first[k];
        }
        tiles.begin(tile.x, tile.y, tile.width, first, start);
    }

    @Override
    public int samples(int x, int y) {
        return tiles == null ? samplesOf(x, y) : 0;
    }

    private int samplesOf(int x, int y) {
        return Dither.at(x, y) < doubled ? 2 * fewer : fewer;
    }

    @Override
    public void grow(FilmTile tile, TileGrowth growth) {
        begin(tile);
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                beginPixel(x, y);
                growPixel(tile, x, y, growth);
            }
        }
    }

    private void growPixel(FilmTile tile, int x, int y, TileGrowth growth) {
        int samples = samplesOf(x, y);
        spread.begin(samples);
        int there = growth.begin(tile, x, y, samples, spread);
        if (there < samples) {
            // There is a half of them at most: all others or none.
            int half = (samples + 1) / 2;
            take(tile, x, y, there, half);
            growth.half(tile, x, y);
            for (int s = half; s < samples; s++) {
                take(tile, x, y, s, s + 1);
                growth.add(color);
            }
            tile.spread(x, y, spread);
        }
        growth.end(tile, x, y);
    }

    private void beginPixel(int x, int y) {
        sampler.pixel(settings.seed(), x, y);
        if (exposure != null) {
            exposure.pixel(settings.seed(), x, y);
        }
    }

    private void renderPixel(FilmTile tile, int x, int y, int pass, int passes) {
        beginPixel(x, y);
        int samples = samplesOf(x, y);
        if (passes > 1) {
            int end = TilePasses.firstSample(samples, pass + 1, passes);
            for (int s = TilePasses.firstSample(samples, pass, passes); s < end; s++) {
                sample(tile, x, y, s);
            }
            return;
        }
        spread.begin(samples);
        take(tile, x, y, 0, samples);
        tile.spread(x, y, spread);
    }

    /** Takes samples that the spread hears of. */
    private void take(FilmTile tile, int x, int y, int from, int to) {
        for (int s = from; s < to; s++) {
            sample(tile, x, y, s);
            spread.at(dx, dy);
            spread.add(color[0], color[1], color[2]);
        }
    }

    private void sample(FilmTile tile, int x, int y, int index) {
        sampler.sample(index);
        dx = sampler.filmX();
        dy = sampler.filmY();
        if (tiles != null) {
            tiles.next(color);
        } else if (exposure == null) {
            scene.camera.ray((x + dx) / settings.width(), (y + dy) / settings.height(), sampler, ray);
            shader.shade(ray, sampler, color);
        } else {
            exposure.shade(index, (x + dx) / settings.width(), (y + dy) / settings.height(), ray, sampler, color);
        }
        tile.add(x, y, color[0], color[1], color[2]);
    }
}

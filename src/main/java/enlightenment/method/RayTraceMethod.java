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
 * Evenly spaced camera rays, the paper's first phase: well-distributed positions in every pixel, each shaded once; antialias² of them
 * unless a budget sets their number.
 */
public final class RayTraceMethod implements TileIntegrator {
    private final CompiledScene scene;
    private final RenderSettings settings;
    /** Shades single samples; null if {@link #tiles} shades. */
    private final Shader shader;

    /** Shades all samples of a tile; null if {@link #shader} shades them one by one. */
    private final TileShader tiles;

    /** Assigns moments to samples; null if the scene has only one. */
    private final Exposure exposure;

    private final Ray ray = new Ray();
    private final SobolSampler sampler = new SobolSampler();
    private final SampleSpread spread = new SampleSpread();
    private final double[] color = new double[3];

    /** The position of the last sample within its pixel, 0..1. */
    private double dx;

    private double dy;

    /** The smaller number of samples per pixel; other pixels have twice as many. */
    private final int fewer;

    /** The share of pixels that have twice as many samples. */
    private final double doubled;

    /**
     * Takes this number of samples per pixel in the mean: the power of two below in some pixels and that above in the others, since points
     * are distributed best at powers of two.
     *
     * @param scene has no instants, or is rendered at the time of its frame
     * @param shader shades each camera ray
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

    /**
     * Makes the method with the shader of the scene's shading, at all moments of the scene.
     *
     * @param samples as for the constructor
     */
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

    /**
     * Makes the method with the shader of the scene's shading, and records its samples in a log.
     *
     * @param samples as for the constructor
     */
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

    /** Makes the method with a shader for each moment of the scene. */
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

    /** Makes the method with a shader of whole tiles. Its tiles cannot be continued from samples taken elsewhere. */
    public static RayTraceMethod ofTiles(
            CompiledScene scene, RenderSettings settings, double samples, TileShader shader) {
        return new RayTraceMethod(scene, settings, null, shader, null, samples);
    }

    /** Makes the method for direct light alone, of physical shading: {@link PathPart#DIRECT}. */
    public static RayTraceMethod ofDirectLight(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> new PathIntegrator(moment, counted, PathPart.DIRECT));
    }

    /** Makes the method for reflectance in place of radiance, of physical shading: {@link PathPart#ALBEDO}. */
    public static RayTraceMethod ofAlbedo(
            CompiledScene scene, RenderSettings settings, RayCounters counters, double samples) {
        return of(
                scene,
                settings,
                counters,
                samples,
                (moment, counted) -> new PathIntegrator(moment, counted, PathPart.ALBEDO));
    }

    /** Makes the method for the light that no light path can bring to the eye, of physical shading: {@link SeenLight}. */
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

    /** Passes the numbers of each pixel's samples to the tile shader. */
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
            // Unless all samples exist, at most half of them do.
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

    /** Takes samples whose positions and values are recorded in the pixel's spread. */
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

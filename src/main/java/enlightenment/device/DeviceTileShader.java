package enlightenment.device;

import enlightenment.classic.shading.ClassicShader;
import enlightenment.method.TileShader;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.transport.image.EyeImages;
import enlightenment.transport.path.PathIntegrator;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Shades camera samples on a device, and those that it leaves to the host here: where surfaces touch, and wherever a rule is rare. After a
 * failure of the device all of them are shaded here. One per thread.
 *
 * <p>What the device does is counted but for its tests and hits of primitives.
 */
public final class DeviceTileShader implements TileShader {
    /** Samples of a batch: less than a second of work for a slow device. */
    private static final int BATCH = 1 << 16;

    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RayCounters counters;
    private final Shader host;

    /** Images of lamps that samples may show; null in classic shading. */
    private final EyeImages images;

    private final ShadedSamples shaded;
    private final Consumer<DeviceFailure> failures;

    /** Null after a failure. */
    private DeviceKernel kernel;

    private final SobolSampler sampler = new SobolSampler();
    private final Ray ray = new Ray();
    private double[] colors = {};
    private int[] states = {};
    private final int[] counts = new int[DeviceKernel.COUNTS];
    private BooleanSupplier cancelled = () -> false;

    private int x;
    private int y;
    private int width;
    private int[] first;
    private int[] start;

    /** The next sample, the pixel that it is in, and the samples that are shaded already. */
    private int index;

    private int pixel;
    private int begin;
    private int end;

    /**
     * @param counters are added to
     * @param kernel has the scene; closed by the caller
     * @param shaded counts the samples
     * @param failures receives the failure of the device, once
     */
    public DeviceTileShader(
            CompiledScene scene,
            RenderSettings settings,
            RayCounters counters,
            DeviceKernel kernel,
            ShadedSamples shaded,
            Consumer<DeviceFailure> failures) {
        this.scene = scene;
        this.settings = settings;
        this.counters = counters;
        this.kernel = kernel;
        this.shaded = shaded;
        this.failures = failures;
        if (scene.physical == null) {
            images = null;
            host = ClassicShader.ofColors(
                    scene, BuiltInMethod.RayTraceSettings.of(settings).shadowSamples(), counters);
        } else {
            PathIntegrator paths = new PathIntegrator(scene, counters);
            images = paths.images();
            host = paths;
        }
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        cancelled = condition;
        host.stopWhen(condition);
    }

    @Override
    public void begin(int left, int top, int columns, int[] firsts, int[] starts) {
        x = left;
        y = top;
        width = columns;
        first = firsts;
        start = starts;
        index = 0;
        pixel = 0;
        begin = 0;
        end = 0;
        double w = settings.width();
        double h = settings.height();
        int rows = firsts.length / columns;
        host.beginTile(left / w, top / h, (left + columns) / w, (top + rows) / h);
    }

    @Override
    public void next(double[] rgb) {
        while (start[pixel + 1] <= index) {
            pixel++;
        }
        if (index == end) {
            shadeBatch();
        }
        int k = index - begin;
        if (kernel == null || states[k] != 0) {
            shadeHere(rgb);
        } else {
            System.arraycopy(colors, 3 * k, rgb, 0, 3);
        }
        index++;
    }

    private void shadeBatch() {
        if (cancelled.getAsBoolean()) {
            throw new CancellationException();
        }
        begin = end;
        end = Math.min(start[start.length - 1], begin + BATCH);
        if (kernel == null) {
            return;
        }
        int size = end - begin;
        if (states.length < size) {
            states = new int[size];
            colors = new double[3 * size];
        }
        try {
            kernel.shade(
                    new DeviceKernel.Batch(settings.seed(), x, y, width, first, start, begin, end),
                    colors,
                    states,
                    counts);
        } catch (DeviceFailure e) {
            kernel = null;
            failures.accept(e);
            return;
        }
        leaveImages();
        count(size);
    }

    /** Leaves samples to the host in pixels that show images of lamps: an image is a polygon of any number of corners. */
    private void leaveImages() {
        if (images == null || !images.mayShow()) {
            return;
        }
        int at = pixel;
        for (int k = begin; k < end; k++) {
            while (start[at + 1] <= k) {
                at++;
            }
            setSampler(at, k);
            if (images.mayShow(sampler.column() + sampler.filmX(), sampler.row() + sampler.filmY())) {
                states[k - begin] = 1;
            }
        }
    }

    /** Sets the sampler to a sample of the tile, by its pixel and its own number. */
    private void setSampler(int ofPixel, int sample) {
        sampler.pixel(settings.seed(), x + ofPixel % width, y + ofPixel / width);
        sampler.sample(first[ofPixel] + sample - start[ofPixel]);
    }

    private void count(int size) {
        int done = 0;
        for (int k = 0; k < size; k++) {
            done += states[k] == 0 ? 1 : 0;
        }
        shaded.addDevice(done);
        counters.cameraRays += done;
        counters.shadowRays += counts[0];
        counters.mirrorRays += counts[1];
        counters.refractedRays += counts[2];
        counters.lightSamples += counts[3];
        counters.textureLookups += counts[4];
    }

    private void shadeHere(double[] rgb) {
        shaded.addHost();
        setSampler(pixel, index);
        scene.camera.ray(
                (sampler.column() + sampler.filmX()) / settings.width(),
                (sampler.row() + sampler.filmY()) / settings.height(),
                sampler,
                ray);
        host.shade(ray, sampler, rgb);
    }
}

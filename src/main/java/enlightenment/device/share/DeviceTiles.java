package enlightenment.device.share;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceTileShader;
import enlightenment.device.ShadedSamples;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.TileIntegrator;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.function.Consumer;

/** A scene on a device, whose tiles it shades for one thread. To be closed by that thread. */
public final class DeviceTiles implements AutoCloseable {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final DeviceKernel kernel;
    private final ShadedSamples shaded;
    private final Consumer<DeviceFailure> failures;

    /**
     * @param shaded counts the samples
     * @param failures receives the failure of the device, if it fails
     */
    DeviceTiles(
            CompiledScene scene,
            RenderSettings settings,
            DeviceKernel kernel,
            ShadedSamples shaded,
            Consumer<DeviceFailure> failures) {
        this.scene = scene;
        this.settings = settings;
        this.kernel = kernel;
        this.shaded = shaded;
        this.failures = failures;
    }

    /**
     * Makes the integrator of tiles, in place of the one before.
     *
     * @param samples per pixel, in the mean
     * @param counters are added to
     */
    public TileIntegrator integrator(double samples, RayCounters counters) {
        DeviceTileShader shader = new DeviceTileShader(scene, settings, counters, kernel, shaded, failures);
        return RayTraceMethod.ofTiles(scene, settings, samples, shader);
    }

    @Override
    public void close() {
        kernel.close();
    }
}

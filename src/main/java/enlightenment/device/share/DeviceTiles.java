package enlightenment.device.share;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceTileShader;
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
    private final Consumer<DeviceFailure> failures;
    private final Consumer<DeviceTiles> closed;

    /** Null until the integrator is made. */
    private DeviceTileShader shader;

    private long doneBefore;
    private long leftBefore;

    /**
     * @param failures receives the failure of the device, if it fails
     * @param closed receives this when it is closed
     */
    DeviceTiles(
            CompiledScene scene,
            RenderSettings settings,
            DeviceKernel kernel,
            Consumer<DeviceFailure> failures,
            Consumer<DeviceTiles> closed) {
        this.closed = closed;
        this.scene = scene;
        this.settings = settings;
        this.kernel = kernel;
        this.failures = failures;
    }

    /**
     * Makes the integrator of tiles, in place of the one before.
     *
     * @param samples per pixel, in the mean
     * @param counters are added to
     */
    public TileIntegrator integrator(double samples, RayCounters counters) {
        countShaded();
        shader = new DeviceTileShader(scene, settings, counters, kernel, failures);
        return RayTraceMethod.ofTiles(scene, settings, samples, shader);
    }

    private void countShaded() {
        doneBefore = done();
        leftBefore = leftToHost();
        shader = null;
    }

    /** The number of samples that the device has shaded. */
    long done() {
        return doneBefore + (shader == null ? 0 : shader.done());
    }

    /** The number of samples that were shaded here. */
    long leftToHost() {
        return leftBefore + (shader == null ? 0 : shader.leftToHost());
    }

    @Override
    public void close() {
        closed.accept(this);
        kernel.close();
    }
}

package enlightenment.render;

import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceChoice;
import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceScene;
import enlightenment.device.DeviceTileShader;
import enlightenment.device.opencl.OpenClDevices;
import enlightenment.math.InvalidValueException;
import enlightenment.method.RayTraceMethod;
import enlightenment.method.TileIntegrator;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import enlightenment.world.parts.RayCounters;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A device that takes part in a render: threads of its own take units of work as those of the processor do, and hand the samples on. Which of
 * them takes a unit changes nothing, since all shade alike.
 */
final class DeviceShare implements AutoCloseable {
    /** One thread makes pixels of samples while the device shades those of the other. */
    private static final int THREADS = 2;

    private final ComputeDevice device;
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final Consumer<String> notes;
    private final List<DeviceKernel> kernels = new ArrayList<>();
    private final List<DeviceTileShader> shaders = new ArrayList<>();
    private boolean hasFailed;

    private DeviceShare(ComputeDevice device, CompiledScene scene, RenderSettings settings, Consumer<String> notes) {
        this.device = device;
        this.scene = scene;
        this.settings = settings;
        this.notes = notes;
    }

    /**
     * Brings the scene of a render to the device that was asked for.
     *
     * @return empty if that is the processor, or what is automatic comes to this
     * @throws InvalidValueException key {@code device}, if the device that was asked for by name cannot take part
     */
    static Optional<DeviceShare> of(RenderRequest request, CompiledScene scene) {
        DeviceChoice choice = DeviceChoice.of(request.device());
        boolean isAuto = choice.kind() == DeviceChoice.Kind.AUTO;
        if (choice.kind() == DeviceChoice.Kind.CPU) {
            return Optional.empty();
        }
        try {
            refuse(request, scene);
            DeviceShare share = new DeviceShare(device(choice), scene, request.settings(), request.progress()::note);
            share.prepare(DeviceScene.of(scene, request.settings()));
            return Optional.of(share);
        } catch (DeviceFailure e) {
            if (isAuto) {
                return Optional.empty();
            }
            throw new InvalidValueException("device", "cannot be " + request.device() + ": " + e.getMessage());
        }
    }

    private static void refuse(RenderRequest request, CompiledScene scene) {
        if (request.settings().method() != Method.RAYTRACE) {
            throw new DeviceFailure("devices render by the method " + Method.RAYTRACE.word() + ", not by "
                    + request.settings().method().word());
        }
        if (!request.archives().isEmpty()) {
            throw new DeviceFailure("devices keep no results");
        }
        DeviceScene.refusal(scene).ifPresent(why -> {
            throw new DeviceFailure("the scene has " + why + ", which no device can do yet");
        });
    }

    private static ComputeDevice device(DeviceChoice choice) {
        List<ComputeDevice> all = OpenClDevices.all();
        if (choice.kind() == DeviceChoice.Kind.AUTO) {
            return all.stream()
                    .filter(d -> d.isGpu() && d.problem().isEmpty())
                    .findFirst()
                    .orElseThrow(() -> new DeviceFailure("there is no graphics processor"));
        }
        if (choice.number() >= all.size()) {
            throw new DeviceFailure("there is no such device; 'devices' lists " + all.size());
        }
        ComputeDevice device = all.get(choice.number());
        if (!device.problem().isEmpty()) {
            throw new DeviceFailure(device.problem());
        }
        return device;
    }

    private void prepare(DeviceScene flat) {
        long needed = THREADS * flat.bytes();
        if (needed > device.memory()) {
            throw new DeviceFailure("the scene takes " + needed + " bytes, and the device has " + device.memory());
        }
        try {
            for (int k = 0; k < THREADS; k++) {
                kernels.add(device.prepare(flat));
            }
        } catch (DeviceFailure e) {
            close();
            throw e;
        }
    }

    /** How many threads it has work for. */
    int threads() {
        return THREADS;
    }

    /** What renders tiles on the device, for one of its threads. */
    TileIntegrator tiles(int thread, double samples, RayCounters counters) {
        DeviceTileShader shader =
                new DeviceTileShader(scene, settings, counters, kernels.get(thread), this::tellFailure);
        shaders.add(shader);
        return RayTraceMethod.ofTiles(scene, settings, samples, shader);
    }

    private synchronized void tellFailure(DeviceFailure failure) {
        if (!hasFailed) {
            hasFailed = true;
            notes.accept(device.name() + ": " + failure.getMessage() + "; the processor goes on alone");
        }
    }

    /** Says which share of a render's camera rays was shaded on the device. */
    void tell(long cameraRays) {
        long done = shaders.stream().mapToLong(DeviceTileShader::done).sum();
        long left = shaders.stream().mapToLong(DeviceTileShader::leftToHost).sum();
        shaders.clear();
        notes.accept(device.name() + " shaded " + done + " of " + cameraRays + " samples"
                + (left > 0 ? " and left " + left + " of its own to the processor" : ""));
    }

    @Override
    public void close() {
        kernels.forEach(DeviceKernel::close);
    }
}

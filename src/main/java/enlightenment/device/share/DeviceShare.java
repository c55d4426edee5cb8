package enlightenment.device.share;

import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceChoice;
import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceProgram;
import enlightenment.device.DeviceScene;
import enlightenment.device.ShadedSamples;
import enlightenment.device.opencl.OpenClDevices;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A device that takes part in renders: some threads hand it the samples of the units that they make. Which thread makes a unit has no
 * influence on the picture, since all shade alike. A program is compiled once for all scenes of its kind. For use by several threads at
 * once; to be closed.
 */
public final class DeviceShare implements AutoCloseable {
    /** The threads that a device keeps busy: one makes pixels of samples while the device shades those of the other. */
    public static final int THREADS = 2;

    private final ComputeDevice device;
    private final Consumer<String> notes;
    private final Map<DeviceScene.Program, DeviceProgram> programs = new EnumMap<>(DeviceScene.Program.class);
    private final ShadedSamples shaded = new ShadedSamples();
    private boolean hasFailed;
    private boolean isClosed;
    private String lastRefusal = "";

    private DeviceShare(ComputeDevice device, Consumer<String> notes) {
        this.device = device;
        this.notes = notes;
    }

    /**
     * Finds the device of a choice.
     *
     * @param notes receives messages for the user
     * @return empty if the choice is the processor, or is automatic and there is no graphics processor
     * @throws DeviceFailure if the device that was chosen by name does not exist or cannot be used
     */
    public static Optional<DeviceShare> of(DeviceChoice choice, Consumer<String> notes) {
        return switch (choice.kind()) {
            case CPU -> Optional.empty();
            case OPENCL -> Optional.of(new DeviceShare(numbered(choice.number()), notes));
            case AUTO -> graphicsProcessor().map(device -> new DeviceShare(device, notes));
        };
    }

    /**
     * As {@link #of}, for a setting that the user has chosen.
     *
     * @return null for empty
     * @throws InvalidValueException key {@code device}, in place of a {@link DeviceFailure}
     */
    public static DeviceShare chosen(DeviceChoice choice, Consumer<String> notes) {
        try {
            return of(choice, notes).orElse(null);
        } catch (DeviceFailure e) {
            throw new InvalidValueException("device", "cannot be used: " + e.getMessage());
        }
    }

    private static Optional<ComputeDevice> graphicsProcessor() {
        try {
            return OpenClDevices.all().stream()
                    .filter(d -> d.isGpu() && d.problem().isEmpty())
                    .findFirst();
        } catch (DeviceFailure e) {
            return Optional.empty();
        }
    }

    private static ComputeDevice numbered(int number) {
        List<ComputeDevice> all = OpenClDevices.all();
        if (number >= all.size()) {
            throw new DeviceFailure("there is no such device; 'devices' lists " + all.size());
        }
        ComputeDevice device = all.get(number);
        if (!device.problem().isEmpty()) {
            throw new DeviceFailure(device.problem());
        }
        return device;
    }

    /**
     * Copies a scene to the device, for some threads.
     *
     * @param settings of the render, whose method is not {@link Method#AUTO}
     * @return one for each thread
     * @throws DeviceFailure if the device cannot take part in this render, or this object is closed
     */
    public List<DeviceTiles> prepare(CompiledScene scene, RenderSettings settings, int threads) {
        if (settings.method() != Method.RAYTRACE) {
            throw new DeviceFailure("devices render by the method " + Method.RAYTRACE.word() + ", not by "
                    + settings.method().word());
        }
        DeviceScene.refusal(scene).ifPresent(why -> {
            throw new DeviceFailure("the scene has " + why + ", which no device can do yet");
        });
        DeviceScene flat = DeviceScene.of(scene, settings);
        long needed = THREADS * flat.bytes();
        if (needed > device.memory()) {
            throw new DeviceFailure("the scene takes " + needed + " bytes, and the device has " + device.memory());
        }
        DeviceProgram program = program(flat.program());
        List<DeviceTiles> made = new ArrayList<>();
        try {
            for (int k = 0; k < threads; k++) {
                made.add(new DeviceTiles(scene, settings, program.prepare(flat), shaded, this::failed));
            }
            return made;
        } catch (DeviceFailure e) {
            made.forEach(DeviceTiles::close);
            throw e;
        }
    }

    private synchronized DeviceProgram program(DeviceScene.Program which) {
        if (isClosed) {
            throw new DeviceFailure("it is closed");
        }
        return programs.computeIfAbsent(which, device::compile);
    }

    /**
     * As {@link #prepare} for one thread, but empty if the device cannot take part; the reason is a note, once for all scenes with the same.
     * A thread that comes after the end, when this object is closed, is no reason for a note.
     */
    public Optional<DeviceTiles> tryPrepare(CompiledScene scene, RenderSettings settings) {
        try {
            return Optional.of(prepare(scene, settings, 1).get(0));
        } catch (DeviceFailure e) {
            refused(e.getMessage());
            return Optional.empty();
        }
    }

    private synchronized void refused(String reason) {
        if (!isClosed && !reason.equals(lastRefusal)) {
            lastRefusal = reason;
            notes.accept(device.name() + " takes no part: " + reason);
        }
    }

    private synchronized void failed(DeviceFailure failure) {
        if (!hasFailed) {
            hasFailed = true;
            notes.accept(device.name() + ": " + failure.getMessage() + "; the processor goes on alone");
        }
    }

    /** Notes how many samples the device has shaded so far, unless it took no part: all of them if no thread renders with it. */
    public void note() {
        long left = shaded.host();
        if (shaded.device() + left > 0) {
            notes.accept(device.name() + " shaded " + shaded.device() + " samples"
                    + (left > 0 ? " and left " + left + " to the processor" : ""));
        }
    }

    /** Closes what no {@link DeviceTiles} still uses; these are closed by their threads. */
    @Override
    public synchronized void close() {
        isClosed = true;
        programs.values().forEach(DeviceProgram::close);
        programs.clear();
    }
}

package enlightenment.device.share;

import enlightenment.device.DeviceChoice;
import enlightenment.device.DeviceFailure;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import enlightenment.world.CompiledScene;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** A device that has the scene of one render of this process, ready before the first unit; or none. To be closed. */
public final class PreparedDevice implements AutoCloseable {
    /** No device. */
    public static final PreparedDevice NONE = new PreparedDevice(null, List.of());

    /** Null for none. */
    private final DeviceShare share;

    private final List<DeviceTiles> tiles;

    private PreparedDevice(DeviceShare share, List<DeviceTiles> tiles) {
        this.share = share;
        this.tiles = tiles;
    }

    /**
     * Copies the scene of a render to the device that was asked for.
     *
     * @param word what {@link DeviceChoice#of} reads
     * @param settings of the render, whose method is chosen
     * @param notes receives messages for the user
     * @throws InvalidValueException key {@code device}, if the device that was asked for by name cannot take part
     */
    public static PreparedDevice of(String word, CompiledScene scene, RenderSettings settings, Consumer<String> notes) {
        DeviceChoice choice = DeviceChoice.of(word);
        try {
            Optional<DeviceShare> share = DeviceShare.of(choice, notes);
            return share.isPresent() ? of(share.get(), scene, settings) : NONE;
        } catch (DeviceFailure e) {
            if (choice.kind() == DeviceChoice.Kind.AUTO) {
                return NONE;
            }
            throw new InvalidValueException("device", "cannot be " + word + ": " + e.getMessage());
        }
    }

    private static PreparedDevice of(DeviceShare share, CompiledScene scene, RenderSettings settings) {
        try {
            return new PreparedDevice(share, share.prepare(scene, settings, DeviceShare.THREADS));
        } catch (DeviceFailure e) {
            share.close();
            throw e;
        }
    }

    /** One for each thread that the device keeps busy; empty for no device. */
    public List<DeviceTiles> tiles() {
        return tiles;
    }

    /** Notes how many samples the device has shaded, if there is one; called while no thread renders. */
    public void note() {
        if (share != null) {
            share.note();
        }
    }

    @Override
    public void close() {
        tiles.forEach(DeviceTiles::close);
        if (share != null) {
            share.close();
        }
    }
}

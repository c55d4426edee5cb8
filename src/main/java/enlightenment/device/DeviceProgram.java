package enlightenment.device;

/** A program that is compiled for a device. For use by several threads at once; to be closed. */
public interface DeviceProgram extends AutoCloseable {
    /**
     * Copies a scene to the device.
     *
     * @return for one thread; may be used after this program is closed
     * @throws DeviceFailure if the device does not take it, or this program is closed
     */
    DeviceKernel prepare(DeviceScene scene);

    @Override
    void close();
}

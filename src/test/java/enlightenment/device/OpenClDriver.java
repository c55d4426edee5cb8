package enlightenment.device;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.device.opencl.DriverTrial;
import enlightenment.device.opencl.OpenClDevices;
import java.util.List;

/** The driver for OpenCL that tests need. */
public final class OpenClDriver {
    private OpenClDriver() {}

    /** The devices that can be used; the test is skipped where there is none. */
    public static List<ComputeDevice> assume() {
        List<ComputeDevice> devices = List.of();
        try {
            devices = OpenClDevices.all().stream()
                    .filter(d -> d.problem().isEmpty() && DriverTrial.compiles(d))
                    .toList();
        } catch (DeviceFailure e) {
            // None.
        }
        assumeTrue(!devices.isEmpty(), "no driver for OpenCL that compiles anything is installed");
        return devices;
    }
}

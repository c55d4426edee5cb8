package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_DEVICE_ADDRESS_BITS;
import static org.lwjgl.opencl.CL10.CL_DEVICE_AVAILABLE;
import static org.lwjgl.opencl.CL10.CL_DEVICE_COMPILER_AVAILABLE;
import static org.lwjgl.opencl.CL10.CL_DEVICE_EXTENSIONS;
import static org.lwjgl.opencl.CL10.CL_DEVICE_GLOBAL_MEM_SIZE;
import static org.lwjgl.opencl.CL10.CL_DEVICE_MAX_CLOCK_FREQUENCY;
import static org.lwjgl.opencl.CL10.CL_DEVICE_MAX_COMPUTE_UNITS;
import static org.lwjgl.opencl.CL10.CL_DEVICE_NAME;
import static org.lwjgl.opencl.CL10.CL_DEVICE_TYPE;
import static org.lwjgl.opencl.CL10.CL_DEVICE_TYPE_GPU;
import static org.lwjgl.opencl.CL10.CL_DEVICE_VENDOR;

import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceProgram;
import enlightenment.device.DeviceScene;

/** A device of a driver. */
final class OpenClDevice implements ComputeDevice {
    private static final String DOUBLES = "cl_khr_fp64";

    final long platform;
    final long id;
    private final String name;
    private final long memory;
    private final String speed;
    private final String problem;
    private final boolean isGpu;

    OpenClDevice(long platform, long id) {
        this.platform = platform;
        this.id = id;
        name = OpenClCalls.deviceText(id, CL_DEVICE_NAME) + " (" + OpenClCalls.deviceText(id, CL_DEVICE_VENDOR) + ")";
        memory = OpenClCalls.deviceLong(id, CL_DEVICE_GLOBAL_MEM_SIZE);
        isGpu = (OpenClCalls.deviceLong(id, CL_DEVICE_TYPE) & CL_DEVICE_TYPE_GPU) != 0;
        speed = OpenClCalls.deviceInt(id, CL_DEVICE_MAX_COMPUTE_UNITS) + (isGpu ? " units" : " cores") + " at "
                + OpenClCalls.deviceInt(id, CL_DEVICE_MAX_CLOCK_FREQUENCY) + " MHz";
        problem = problemOf(id);
    }

    private static String problemOf(long id) {
        if (OpenClCalls.deviceInt(id, CL_DEVICE_AVAILABLE) == 0) {
            return "it is not available";
        }
        if (OpenClCalls.deviceInt(id, CL_DEVICE_COMPILER_AVAILABLE) == 0) {
            return "it has no compiler";
        }
        if (OpenClCalls.deviceInt(id, CL_DEVICE_ADDRESS_BITS) == 0) {
            return "its driver does not answer";
        }
        boolean hasDoubles = OpenClCalls.longText(id, CL_DEVICE_EXTENSIONS).contains(DOUBLES);
        return hasDoubles ? "" : "it does not compute in double precision";
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public boolean isGpu() {
        return isGpu;
    }

    @Override
    public long memory() {
        return memory;
    }

    @Override
    public String speed() {
        return speed;
    }

    @Override
    public String problem() {
        return problem;
    }

    @Override
    public double measureDoubleRate() {
        try (OpenClProgram program = new OpenClProgram(this, DeviceScene.Program.CLASSIC)) {
            return OpenClTrial.doubleRate(program);
        }
    }

    @Override
    public DeviceProgram compile(DeviceScene.Program which) {
        return new OpenClProgram(this, which);
    }
}

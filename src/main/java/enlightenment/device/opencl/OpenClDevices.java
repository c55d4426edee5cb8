package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_DEVICE_TYPE_ALL;
import static org.lwjgl.opencl.CL10.CL_SUCCESS;

import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceFailure;
import enlightenment.machine.OptionalLibrary;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import org.lwjgl.PointerBuffer;
import org.lwjgl.opencl.CL;
import org.lwjgl.opencl.CL10;
import org.lwjgl.system.Configuration;
import org.lwjgl.system.Library;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.Platform;

/** The devices of all drivers of this machine. */
public final class OpenClDevices {
    /** No machine has more platforms, nor a platform more devices. */
    private static final int MOST = 256;

    private OpenClDevices() {}

    /**
     * All of them, in the order of the drivers.
     *
     * @throws DeviceFailure if there is no driver, or the library that binds drivers is missing
     */
    public static List<ComputeDevice> all() {
        if (!OptionalLibrary.isPresent("org.lwjgl.opencl.CL")) {
            throw new DeviceFailure(
                    "other devices need the libraries org.lwjgl:lwjgl and org.lwjgl:lwjgl-opencl with the"
                            + " natives of this system, which are on neither class path nor module path");
        }
        return Bound.all();
    }

    /** What needs the library: loaded where that is there. */
    private static final class Bound {
        static synchronized List<ComputeDevice> all() {
            load();
            List<ComputeDevice> found = new ArrayList<>();
            try (MemoryStack stack = MemoryStack.stackPush()) {
                PointerBuffer platforms = stack.mallocPointer(MOST);
                IntBuffer count = stack.mallocInt(1);
                if (CL10.clGetPlatformIDs(platforms, count) != CL_SUCCESS) {
                    throw new DeviceFailure("no driver for OpenCL is installed");
                }
                for (int k = 0; k < Math.min(count.get(0), MOST); k++) {
                    addDevices(platforms.get(k), stack, found);
                }
            }
            return found;
        }

        private static void load() {
            if (Configuration.DEBUG_STREAM.get() == null) {
                // Whatever fails is thrown here; the library need not print it.
                Configuration.DEBUG_STREAM.set(new PrintStream(OutputStream.nullOutputStream()));
            }
            Configuration.OPENCL_EXPLICIT_INIT.set(true);
            try {
                Library.initialize();
            } catch (LinkageError e) {
                throw new DeviceFailure("the natives of the library org.lwjgl:lwjgl for this system are missing", e);
            }
            if (!isLoaded()) {
                create();
            }
        }

        private static boolean isLoaded() {
            try {
                return CL.getFunctionProvider() != null;
            } catch (IllegalStateException e) {
                return false;
            }
        }

        private static void create() {
            try {
                if (Platform.get() == Platform.LINUX) {
                    // The name of what programs load; the name without a number belongs to the headers.
                    CL.create("libOpenCL.so.1");
                } else {
                    CL.create();
                }
            } catch (LinkageError | IllegalStateException e) {
                throw new DeviceFailure("no driver for OpenCL is installed", e);
            }
        }

        private static void addDevices(long platform, MemoryStack stack, List<ComputeDevice> found) {
            PointerBuffer devices = stack.mallocPointer(MOST);
            IntBuffer count = stack.mallocInt(1);
            if (CL10.clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, devices, count) == CL_SUCCESS) {
                for (int k = 0; k < Math.min(count.get(0), MOST); k++) {
                    found.add(new OpenClDevice(platform, devices.get(k)));
                }
            }
        }
    }
}

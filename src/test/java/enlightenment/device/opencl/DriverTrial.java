package enlightenment.device.opencl;

import enlightenment.device.ComputeDevice;
import java.nio.IntBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.opencl.CL10;
import org.lwjgl.system.MemoryStack;

/** Whether a driver works at all, whatever it makes of the renderer's program. */
public final class DriverTrial {
    private static final String LEAST = "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n"
            + "__kernel void least(__global double *x) { x[0] = sqrt(x[1]); }";

    private DriverTrial() {}

    /** Whether the driver compiles a program of one line. */
    public static boolean compiles(ComputeDevice device) {
        OpenClDevice of = (OpenClDevice) device;
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            PointerBuffer properties = stack.pointers(CL10.CL_CONTEXT_PLATFORM, of.platform, 0);
            long context = CL10.clCreateContext(properties, of.id, null, 0, code);
            if (code.get(0) != CL10.CL_SUCCESS) {
                return false;
            }
            long program = CL10.clCreateProgramWithSource(context, LEAST, code);
            int built = CL10.clBuildProgram(program, of.id, "-cl-std=CL1.2", null, 0);
            CL10.clReleaseProgram(program);
            CL10.clReleaseContext(context);
            return built == CL10.CL_SUCCESS;
        }
    }
}

package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_CONTEXT_PLATFORM;
import static org.lwjgl.opencl.CL10.CL_PROGRAM_BUILD_LOG;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceProgram;
import enlightenment.device.DeviceScene;
import enlightenment.device.KernelSource;
import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import org.lwjgl.PointerBuffer;
import org.lwjgl.opencl.CL10;
import org.lwjgl.system.MemoryStack;

/** A program that is compiled for a device. For use by several threads at once; to be closed. */
final class OpenClProgram implements DeviceProgram {
    /**
     * Contraction of products and sums is off in the source; nothing else may be relaxed either. What OpenCL C 1.2 has is all that the
     * program asks for.
     */
    private static final String OPTIONS = "-cl-std=CL1.2";

    /** The releases of what was made, the last first. */
    private final Deque<Runnable> releases = new ArrayDeque<>();

    /** After a failure nothing may be asked of the device, not even to release what it holds: that could wait for ever. */
    private volatile boolean isLost;

    /**
     * This object, until it is closed, and the queues. A driver may abort the process that uses what was released, so that users are
     * counted before they use anything.
     */
    private int users = 1;

    private boolean isClosed;

    private long context;
    private final OpenClDevice device;
    private long program;

    /**
     * Compiles a program, and checks that the device computes as Java does.
     *
     * @throws DeviceFailure if that fails
     */
    OpenClProgram(OpenClDevice device, DeviceScene.Program which) {
        this.device = device;
        try {
            open();
            compile(which);
            OpenClTrial.checkArithmetic(this);
        } catch (DeviceFailure e) {
            close();
            throw e;
        }
    }

    private void open() {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            PointerBuffer properties = stack.pointers(CL_CONTEXT_PLATFORM, device.platform, 0);
            context = CL10.clCreateContext(properties, device.id, null, 0, code);
            OpenClCalls.check(code.get(0), "open the device");
            releases.push(() -> CL10.clReleaseContext(context));
        }
    }

    private void compile(DeviceScene.Program which) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            program = CL10.clCreateProgramWithSource(context, KernelSource.text(which), code);
            OpenClCalls.check(code.get(0), "take the program");
            releases.push(() -> CL10.clReleaseProgram(program));
            int built = CL10.clBuildProgram(program, device.id, OPTIONS, null, 0);
            if (built != CL10.CL_SUCCESS) {
                String log = OpenClCalls.text((value, size) ->
                        CL10.clGetProgramBuildInfo(program, device.id, CL_PROGRAM_BUILD_LOG, value, size));
                throw new DeviceFailure("its compiler refuses the program: " + log);
            }
        }
    }

    long id() {
        return program;
    }

    long context() {
        return context;
    }

    /**
     * Counts one more user of the program and its context, who lets go of them in the end.
     *
     * @throws DeviceFailure if the program is closed
     */
    synchronized void hold() {
        if (isClosed) {
            throw new DeviceFailure("its program is closed");
        }
        users++;
    }

    /** Releases the program and its context after their last user. */
    synchronized void letGo() {
        users--;
        while (users == 0 && !isLost && !releases.isEmpty()) {
            releases.pop().run();
        }
    }

    /** Makes a queue of commands, for an owner who {@link #hold holds} the program and releases the queue. */
    long queue() {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            long queue = CL10.clCreateCommandQueue(context, device.id, 0, code);
            OpenClCalls.check(code.get(0), "make a queue of commands");
            return queue;
        }
    }

    /** Marks the device as lost: nothing is asked of it from now on, by any queue. */
    void giveUp() {
        isLost = true;
    }

    boolean isLost() {
        return isLost;
    }

    @Override
    public DeviceKernel prepare(DeviceScene scene) {
        OpenClQueue queue = new OpenClQueue(this);
        try {
            return new OpenClKernel(queue, scene);
        } catch (DeviceFailure e) {
            queue.close();
            throw e;
        }
    }

    /** Kernels may outlive it: they hold the program. */
    @Override
    public synchronized void close() {
        if (!isClosed) {
            isClosed = true;
            letGo();
        }
    }
}

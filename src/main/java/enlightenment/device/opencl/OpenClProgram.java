package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_COMPLETE;
import static org.lwjgl.opencl.CL10.CL_CONTEXT_PLATFORM;
import static org.lwjgl.opencl.CL10.CL_EVENT_COMMAND_EXECUTION_STATUS;
import static org.lwjgl.opencl.CL10.CL_MEM_READ_WRITE;
import static org.lwjgl.opencl.CL10.CL_PROGRAM_BUILD_LOG;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceScene;
import enlightenment.device.KernelSource;
import java.nio.DoubleBuffer;
import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.lwjgl.PointerBuffer;
import org.lwjgl.opencl.CL10;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/** The program on a device, with memory and a queue of commands: for one thread. To be closed. */
final class OpenClProgram implements AutoCloseable {
    /**
     * Contraction of products and sums is off in the source; nothing else may be relaxed either. What OpenCL C 1.2 has is all that the
     * program asks for.
     */
    private static final String OPTIONS = "-cl-std=CL1.2";

    /** A batch that takes longer than this is taken for a device that hangs. */
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    private static final long SHORT_WAIT = TimeUnit.MICROSECONDS.toNanos(100);
    private static final int WORK_GROUP = 64;

    /** What is to be released, the last first. */
    private final Deque<Runnable> releases = new ArrayDeque<>();

    /** After a failure nothing may be asked of the device, not even to release what it holds: that could wait for ever. */
    private boolean isLost;

    private long context;
    private long queue;
    private long program;

    /**
     * Compiles a program.
     *
     * @throws DeviceFailure if that fails
     */
    OpenClProgram(OpenClDevice device, DeviceScene.Program which) {
        try {
            open(device);
            compile(device, which);
        } catch (DeviceFailure e) {
            close();
            throw e;
        }
    }

    private void open(OpenClDevice device) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            PointerBuffer properties = stack.pointers(CL_CONTEXT_PLATFORM, device.platform, 0);
            context = CL10.clCreateContext(properties, device.id, null, 0, code);
            OpenClCalls.check(code.get(0), "open the device");
            releases.push(() -> CL10.clReleaseContext(context));
            queue = CL10.clCreateCommandQueue(context, device.id, 0, code);
            OpenClCalls.check(code.get(0), "make a queue of commands");
            releases.push(() -> CL10.clReleaseCommandQueue(queue));
        }
    }

    private void compile(OpenClDevice device, DeviceScene.Program which) {
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

    /** A kernel of the program. */
    long kernel(String name) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            long made = CL10.clCreateKernel(program, name, code);
            OpenClCalls.check(code.get(0), "find " + name + " in the program");
            releases.push(() -> CL10.clReleaseKernel(made));
            return made;
        }
    }

    /** Memory of the device that holds these numbers. */
    long constant(double[] numbers) {
        long buffer = memory((long) Double.BYTES * numbers.length);
        checkWrite(numbers.length == 0 ? 0 : CL10.clEnqueueWriteBuffer(queue, buffer, true, 0, numbers, null, null));
        return buffer;
    }

    long constant(int[] numbers) {
        long buffer = memory((long) Integer.BYTES * numbers.length);
        checkWrite(numbers.length == 0 ? 0 : CL10.clEnqueueWriteBuffer(queue, buffer, true, 0, numbers, null, null));
        return buffer;
    }

    long constant(float[] numbers) {
        long buffer = memory((long) Float.BYTES * numbers.length);
        checkWrite(numbers.length == 0 ? 0 : CL10.clEnqueueWriteBuffer(queue, buffer, true, 0, numbers, null, null));
        return buffer;
    }

    private static void checkWrite(int code) {
        OpenClCalls.check(code, "write into the device's memory");
    }

    /** Memory of the device, released at the end. */
    long memory(long bytes) {
        long buffer = allocate(Math.max(bytes, Double.BYTES), "give memory");
        releases.push(() -> CL10.clReleaseMemObject(buffer));
        return buffer;
    }

    private long allocate(long bytes, String what) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            long buffer = CL10.clCreateBuffer(context, CL_MEM_READ_WRITE, bytes, code);
            OpenClCalls.check(code.get(0), what);
            return buffer;
        }
    }

    /** Writes numbers into memory that is there. */
    void write(long buffer, int[] numbers) {
        checkWrite(CL10.clEnqueueWriteBuffer(queue, buffer, true, 0, numbers, null, null));
    }

    void read(long buffer, double[] numbers) {
        OpenClCalls.check(CL10.clEnqueueReadBuffer(queue, buffer, true, 0, numbers, null, null), "read");
    }

    void read(long buffer, int[] numbers) {
        OpenClCalls.check(CL10.clEnqueueReadBuffer(queue, buffer, true, 0, numbers, null, null), "read");
    }

    /** Lets nothing be asked of the device from now on. */
    void giveUp() {
        isLost = true;
    }

    /** Runs work items, and waits until they are done. */
    void run(long what, int items) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            long whole = (items + WORK_GROUP - 1L) / WORK_GROUP * WORK_GROUP;
            PointerBuffer event = stack.mallocPointer(1);
            OpenClCalls.check(
                    CL10.clEnqueueNDRangeKernel(queue, what, 1, null, stack.pointers(whole), null, null, event),
                    "run the program");
            OpenClCalls.check(CL10.clFlush(queue), "run the program");
            await(event.get(0), stack.mallocInt(1));
            CL10.clReleaseEvent(event.get(0));
        }
    }

    /** Asks again and again: a driver's own waiting has no end. */
    private void await(long event, IntBuffer status) {
        long since = System.nanoTime();
        while (true) {
            OpenClCalls.check(
                    CL10.clGetEventInfo(event, CL_EVENT_COMMAND_EXECUTION_STATUS, status, null), "tell how it gets on");
            if (status.get(0) == CL_COMPLETE) {
                return;
            }
            if (status.get(0) < 0) {
                isLost = true;
                throw new DeviceFailure("the device gave up (OpenCL error " + status.get(0) + ")");
            }
            if (System.nanoTime() - since > PATIENCE) {
                isLost = true;
                throw new DeviceFailure("the device has not answered for a minute");
            }
            LockSupport.parkNanos(SHORT_WAIT);
        }
    }

    @Override
    public void close() {
        while (!isLost && !releases.isEmpty()) {
            releases.pop().run();
        }
    }

    /** A buffer that grows. */
    final class Buffer {
        long id;
        private long bytes;

        void reserve(long needed) {
            if (needed <= bytes) {
                return;
            }
            long old = id;
            id = allocate(needed, "give memory to a batch");
            if (bytes == 0) {
                releases.push(() -> CL10.clReleaseMemObject(id));
            } else {
                CL10.clReleaseMemObject(old);
            }
            bytes = needed;
        }

        void write(int[] numbers) {
            reserve((long) Integer.BYTES * numbers.length);
            OpenClProgram.this.write(id, numbers);
        }

        void read(double[] out, int size) {
            DoubleBuffer to = MemoryUtil.memAllocDouble(size);
            try {
                OpenClCalls.check(CL10.clEnqueueReadBuffer(queue, id, true, 0, to, null, null), "read");
                to.get(out, 0, size);
            } finally {
                MemoryUtil.memFree(to);
            }
        }

        void read(int[] out, int size) {
            IntBuffer to = MemoryUtil.memAllocInt(size);
            try {
                OpenClCalls.check(CL10.clEnqueueReadBuffer(queue, id, true, 0, to, null, null), "read");
                to.get(out, 0, size);
            } finally {
                MemoryUtil.memFree(to);
            }
        }
    }
}

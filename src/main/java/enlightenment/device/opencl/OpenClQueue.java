package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_COMPLETE;
import static org.lwjgl.opencl.CL10.CL_EVENT_COMMAND_EXECUTION_STATUS;
import static org.lwjgl.opencl.CL10.CL_MEM_READ_WRITE;

import enlightenment.device.DeviceFailure;
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

/** A queue of commands for a device's program, with the memory that they use: for one thread. To be closed. */
final class OpenClQueue implements AutoCloseable {
    /** A batch that takes longer than this is taken for a device that hangs. */
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    private static final long SHORT_WAIT = TimeUnit.MICROSECONDS.toNanos(100);
    private static final int WORK_GROUP = 64;

    private final OpenClProgram program;

    /** The releases of what was made, the last first. */
    private final Deque<Runnable> releases = new ArrayDeque<>();

    private final long queue;

    /** @throws DeviceFailure if the device makes no queue, or the program is closed */
    OpenClQueue(OpenClProgram program) {
        this.program = program;
        program.hold();
        releases.push(program::letGo);
        try {
            queue = program.queue();
        } catch (DeviceFailure e) {
            close();
            throw e;
        }
        releases.push(() -> CL10.clReleaseCommandQueue(queue));
    }

    /** A kernel of the program. */
    long kernel(String name) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer code = stack.mallocInt(1);
            long made = CL10.clCreateKernel(program.id(), name, code);
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
            long buffer = CL10.clCreateBuffer(program.context(), CL_MEM_READ_WRITE, bytes, code);
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

    /** Marks the device as lost: see {@link OpenClProgram#giveUp}. */
    void giveUp() {
        program.giveUp();
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
                program.giveUp();
                throw new DeviceFailure("the device gave up (OpenCL error " + status.get(0) + ")");
            }
            if (System.nanoTime() - since > PATIENCE) {
                program.giveUp();
                throw new DeviceFailure("the device has not answered for a minute");
            }
            LockSupport.parkNanos(SHORT_WAIT);
        }
    }

    @Override
    public void close() {
        while (!program.isLost() && !releases.isEmpty()) {
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
            OpenClQueue.this.write(id, numbers);
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

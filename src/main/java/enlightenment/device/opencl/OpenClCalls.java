package enlightenment.device.opencl;

import static org.lwjgl.opencl.CL10.CL_SUCCESS;

import enlightenment.device.DeviceFailure;
import enlightenment.text.Plain;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.nio.LongBuffer;
import org.lwjgl.BufferUtils;
import org.lwjgl.PointerBuffer;
import org.lwjgl.opencl.CL10;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

/** Calls of the driver that fail with a {@link DeviceFailure}, and texts that it tells, made harmless. */
final class OpenClCalls {
    /** No name is longer. */
    private static final int LONGEST_TEXT = 200;

    private OpenClCalls() {}

    static void check(int code, String what) {
        if (code != CL_SUCCESS) {
            throw new DeviceFailure("the driver cannot " + what + " (OpenCL error " + code + ")");
        }
    }

    /** A text about a platform or a device. */
    interface Query {
        int ask(ByteBuffer value, PointerBuffer size);
    }

    /** Of whatever length, as it is. */
    private static String whole(Query query) {
        PointerBuffer size = BufferUtils.createPointerBuffer(1);
        if (query.ask(null, size) != CL_SUCCESS || size.get(0) < 1 || size.get(0) > 1 << 20) {
            return "";
        }
        ByteBuffer value = BufferUtils.createByteBuffer((int) size.get(0));
        if (query.ask(value, null) != CL_SUCCESS) {
            return "";
        }
        return MemoryUtil.memUTF8(value, value.capacity() - 1).strip();
    }

    static String text(Query query) {
        return Plain.line(whole(query), LONGEST_TEXT);
    }

    static String deviceText(long device, int key) {
        return text((value, size) -> CL10.clGetDeviceInfo(device, key, value, size));
    }

    /** Not to be shown. */
    static String longText(long device, int key) {
        return whole((value, size) -> CL10.clGetDeviceInfo(device, key, value, size));
    }

    static long deviceLong(long device, int key) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            LongBuffer value = stack.mallocLong(1);
            return CL10.clGetDeviceInfo(device, key, value, null) == CL_SUCCESS ? value.get(0) : 0;
        }
    }

    static int deviceInt(long device, int key) {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            IntBuffer value = stack.mallocInt(1);
            return CL10.clGetDeviceInfo(device, key, value, null) == CL_SUCCESS ? value.get(0) : 0;
        }
    }
}

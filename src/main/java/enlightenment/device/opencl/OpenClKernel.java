package enlightenment.device.opencl;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceScene;
import org.lwjgl.opencl.CL10;

/** A scene in the memory of a device. */
final class OpenClKernel implements DeviceKernel {
    private final OpenClQueue queue;
    private final long kernel;
    private final long counts;
    private final OpenClQueue.Buffer first;
    private final OpenClQueue.Buffer start;
    private final OpenClQueue.Buffer rgb;
    private final OpenClQueue.Buffer states;

    /** @throws DeviceFailure if the device does not take the scene */
    OpenClKernel(OpenClQueue queue, DeviceScene scene) {
        this.queue = queue;
        kernel = queue.kernel("shade");
        CL10.clSetKernelArg1p(kernel, 0, queue.constant(scene.doubles()));
        CL10.clSetKernelArg1p(kernel, 1, queue.constant(scene.ints()));
        CL10.clSetKernelArg1p(kernel, 2, queue.constant(scene.floats()));
        counts = queue.constant(new int[COUNTS]);
        CL10.clSetKernelArg1p(kernel, 14, counts);
        first = queue.new Buffer();
        start = queue.new Buffer();
        rgb = queue.new Buffer();
        states = queue.new Buffer();
    }

    @Override
    public void shade(Batch batch, double[] colors, int[] left, int[] counted) {
        int size = batch.end() - batch.begin();
        try {
            first.write(batch.first());
            start.write(batch.start());
            rgb.reserve(3L * Double.BYTES * size);
            states.reserve((long) Integer.BYTES * size);
            queue.write(counts, new int[COUNTS]);
            CL10.clSetKernelArg1l(kernel, 3, batch.seed());
            int[] numbers = {batch.x(), batch.y(), batch.width(), batch.first().length, batch.begin(), batch.end()};
            for (int k = 0; k < numbers.length; k++) {
                CL10.clSetKernelArg1i(kernel, 4 + k, numbers[k]);
            }
            CL10.clSetKernelArg1p(kernel, 10, first.id);
            CL10.clSetKernelArg1p(kernel, 11, start.id);
            CL10.clSetKernelArg1p(kernel, 12, rgb.id);
            CL10.clSetKernelArg1p(kernel, 13, states.id);
            queue.run(kernel, size);
            rgb.read(colors, 3 * size);
            states.read(left, size);
            queue.read(counts, counted);
        } catch (DeviceFailure e) {
            queue.giveUp();
            throw e;
        }
    }

    @Override
    public void close() {
        queue.close();
    }
}

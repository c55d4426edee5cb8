package enlightenment.device.opencl;

import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceScene;
import org.lwjgl.opencl.CL10;

/** A scene in the memory of a device. */
final class OpenClKernel implements DeviceKernel {
    private final OpenClProgram program;
    private final long kernel;
    private final long counts;
    private final OpenClProgram.Buffer first;
    private final OpenClProgram.Buffer start;
    private final OpenClProgram.Buffer rgb;
    private final OpenClProgram.Buffer states;

    private OpenClKernel(OpenClProgram program, DeviceScene scene) {
        this.program = program;
        kernel = program.kernel("shade");
        CL10.clSetKernelArg1p(kernel, 0, program.constant(scene.doubles()));
        CL10.clSetKernelArg1p(kernel, 1, program.constant(scene.ints()));
        CL10.clSetKernelArg1p(kernel, 2, program.constant(scene.floats()));
        counts = program.constant(new int[COUNTS]);
        CL10.clSetKernelArg1p(kernel, 14, counts);
        first = program.new Buffer();
        start = program.new Buffer();
        rgb = program.new Buffer();
        states = program.new Buffer();
    }

    /** Compiles the program, asks the device whether it computes as Java does, and gives it the scene. */
    static OpenClKernel of(OpenClDevice device, DeviceScene scene) {
        OpenClProgram program = new OpenClProgram(device, scene.program());
        try {
            OpenClTrial.checkArithmetic(program);
            return new OpenClKernel(program, scene);
        } catch (DeviceFailure e) {
            program.close();
            throw e;
        }
    }

    @Override
    public void shade(Batch batch, double[] colors, int[] left, int[] counted) {
        int size = batch.end() - batch.begin();
        try {
            first.write(batch.first());
            start.write(batch.start());
            rgb.reserve(3L * Double.BYTES * size);
            states.reserve((long) Integer.BYTES * size);
            program.write(counts, new int[COUNTS]);
            CL10.clSetKernelArg1l(kernel, 3, batch.seed());
            int[] numbers = {batch.x(), batch.y(), batch.width(), batch.first().length, batch.begin(), batch.end()};
            for (int k = 0; k < numbers.length; k++) {
                CL10.clSetKernelArg1i(kernel, 4 + k, numbers[k]);
            }
            CL10.clSetKernelArg1p(kernel, 10, first.id);
            CL10.clSetKernelArg1p(kernel, 11, start.id);
            CL10.clSetKernelArg1p(kernel, 12, rgb.id);
            CL10.clSetKernelArg1p(kernel, 13, states.id);
            program.run(kernel, size);
            rgb.read(colors, 3 * size);
            states.read(left, size);
            program.read(counts, counted);
        } catch (DeviceFailure e) {
            program.giveUp();
            throw e;
        }
    }

    @Override
    public void close() {
        program.close();
    }
}

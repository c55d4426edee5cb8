package enlightenment.device.opencl;

import enlightenment.device.Arithmetic;
import org.lwjgl.opencl.CL10;

/** What is tried on a device before it is trusted, and how fast it is. */
final class OpenClTrial {
    /** Work items, each of which makes a chain of fused operations on four numbers. */
    private static final int ITEMS = 1 << 17;

    private static final int STEPS = 512;
    private static final int OPERATIONS_PER_STEP = 8;
    private static final int RUNS = 4;

    private OpenClTrial() {}

    /** Fails if the device does not compute as Java does. */
    static void checkArithmetic(OpenClProgram compiled) {
        try (OpenClQueue queue = new OpenClQueue(compiled)) {
            double[] inputs = Arithmetic.inputs();
            int count = inputs.length / Arithmetic.INPUTS;
            double[] found = new double[Arithmetic.RESULTS * count];
            long out = queue.memory((long) Double.BYTES * found.length);
            long test = queue.kernel("arithmetic");
            CL10.clSetKernelArg1p(test, 0, queue.constant(inputs));
            CL10.clSetKernelArg1p(test, 1, out);
            CL10.clSetKernelArg1i(test, 2, count);
            queue.run(test, count);
            queue.read(out, found);
            Arithmetic.check(inputs, found);
        }
    }

    /** Operations in double precision in a second, a fused product and sum being two: the best of some runs. */
    static double doubleRate(OpenClProgram compiled) {
        try (OpenClQueue queue = new OpenClQueue(compiled)) {
            long out = queue.memory((long) Double.BYTES * ITEMS);
            long chain = queue.kernel("chain");
            CL10.clSetKernelArg1p(chain, 0, out);
            CL10.clSetKernelArg1i(chain, 1, STEPS);
            long best = Long.MAX_VALUE;
            for (int run = 0; run < RUNS; run++) {
                long since = System.nanoTime();
                queue.run(chain, ITEMS);
                best = Math.min(best, System.nanoTime() - since);
            }
            return (double) ITEMS * STEPS * OPERATIONS_PER_STEP / (best * 1e-9);
        }
    }
}

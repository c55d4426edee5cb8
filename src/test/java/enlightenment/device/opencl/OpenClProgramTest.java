package enlightenment.device.opencl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.device.ComputeDevice;
import enlightenment.device.DeviceFailure;
import enlightenment.device.DeviceKernel;
import enlightenment.device.DeviceKernel.Batch;
import enlightenment.device.DeviceProgram;
import enlightenment.device.DeviceScene;
import enlightenment.device.OpenClDriver;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** When a program ends: a driver aborts the process that uses what was released. */
@Timeout(300)
class OpenClProgramTest {
    private static final int TRIES = 50;
    private final DeviceScene scene = scene();
    private final ComputeDevice device = OpenClDriver.assume().get(0);

    private static DeviceScene scene() {
        Scene scene = SceneReader.read(Path.of("scenes", "cube.json"));
        RenderSettings settings = RenderSettings.of(scene);
        return DeviceScene.of(SceneCompiler.compile(scene, settings), settings);
    }

    private static double[] shade(DeviceKernel kernel) {
        double[] rgb = new double[3];
        kernel.shade(
                new Batch(1, 0, 0, 1, new int[1], new int[] {0, 1}, 0, 1),
                rgb,
                new int[1],
                new int[DeviceKernel.COUNTS]);
        return rgb;
    }

    @Test
    void aClosedProgramTakesNoScene() {
        DeviceProgram program = device.compile(scene.program());
        program.close();
        assertThrows(DeviceFailure.class, () -> program.prepare(scene));
        program.close();
        assertThrows(DeviceFailure.class, () -> program.prepare(scene));
    }

    @Test
    void kernelsOutliveTheirProgram() {
        DeviceProgram program = device.compile(scene.program());
        DeviceKernel kernel = program.prepare(scene);
        double[] before = shade(kernel);
        program.close();
        assertArrayEquals(before, shade(kernel));
        kernel.close();
        kernel.close();
        assertThrows(DeviceFailure.class, () -> program.prepare(scene));
    }

    /** A thread that comes too late gets a failure; one that came in time shades. */
    @Test
    void aProgramIsClosedWhileOthersPrepare() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(1);
        try {
            for (int k = 0; k < TRIES; k++) {
                DeviceProgram program = device.compile(scene.program());
                CountDownLatch begun = new CountDownLatch(1);
                Future<Integer> prepared = threads.submit(() -> prepareUntilClosed(program, begun));
                begun.await();
                program.close();
                assertTrue(prepared.get() > 0);
            }
        } finally {
            threads.shutdownNow();
        }
    }

    private int prepareUntilClosed(DeviceProgram program, CountDownLatch begun) {
        int prepared = 0;
        DeviceKernel kernel = program.prepare(scene);
        double[] expected = shade(kernel);
        while (kernel != null) {
            prepared++;
            assertArrayEquals(expected, shade(kernel));
            kernel.close();
            begun.countDown();
            kernel = tryPrepare(program);
        }
        return prepared;
    }

    private DeviceKernel tryPrepare(DeviceProgram program) {
        try {
            return program.prepare(scene);
        } catch (DeviceFailure e) {
            return null;
        }
    }
}

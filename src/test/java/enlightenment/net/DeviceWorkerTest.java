package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.device.OpenClDriver;
import enlightenment.math.InvalidValueException;
import enlightenment.net.worker.WorkerJobs;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Workers with devices: their tiles are those of other workers, and audits find them so. */
@Timeout(600)
class DeviceWorkerTest {
    private static final byte[] ALONE = Farm.alone();

    private static RenderWorker.Options.Builder withDevice(List<String> log) {
        return Farm.worker(1).device("opencl").log(log::add);
    }

    @Test
    void auditsOfAWorkerWithADeviceAgreeWithThoseOfOthers() throws Exception {
        OpenClDriver.assume();
        ServerOptions.Builder options = Farm.options().auditRate(1).awaitWorkers(2, Farm.TIMEOUT_SECONDS);
        try (Farm farm = new Farm(options).begin()) {
            farm.join(withDevice(new ArrayList<>()).machine("device"));
            farm.join(Farm.worker(1).machine("processor"));
            RenderResult result = farm.result();
            assertTrue(result.complete());
            assertArrayEquals(ALONE, Farm.png(result.image()));
            assertTrue(farm.server.audits().isComplete(), farm.server.audits().toString());
            assertEquals(Set.of(), farm.server.round().snapshot().expelled());
        }
    }

    /** The server has no other threads: without workers it renders by its device, and by processors once it finds itself alone. */
    @Test
    void aServerWithADeviceMakesTheSamePicture() throws Exception {
        OpenClDriver.assume();
        try (Farm farm = new Farm(Farm.options().device("opencl")).begin()) {
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(farm.logHas(" shaded "), farm.log.toString());
        }
    }

    @Test
    void aDeviceThatTheServerLacksIsAWrongSetting() {
        InvalidValueException e = assertThrows(
                InvalidValueException.class, () -> new Farm(Farm.options().device("opencl:255")));
        assertEquals("device", e.key());
    }

    /** Its processor renders what its device does not. */
    @Test
    void aWorkerWhoseDeviceTakesNoPartRendersAllTheSame() throws Exception {
        OpenClDriver.assume();
        List<String> log = Collections.synchronizedList(new ArrayList<>());
        RenderSettings settings = Farm.SETTINGS.withMethod(Method.CLUSTER);
        try (Farm farm = new Farm(Farm.SCENE, settings, Farm.options()).begin()) {
            farm.join(withDevice(log));
            assertArrayEquals(
                    Renderer.render(RenderRequest.of(Farm.SCENE, settings))
                            .image()
                            .toArray(),
                    farm.result().image().toArray());
        }
        List<String> refusals =
                log.stream().filter(l -> l.contains("takes no part")).toList();
        assertEquals(1, refusals.size(), log.toString());
        assertTrue(refusals.get(0).endsWith("devices render by the method raytrace, not by cluster"), refusals.get(0));
    }

    @Test
    void aDeviceThatIsNotThereIsAWrongOption() {
        RenderWorker.Options options = Farm.worker(1).device("opencl:255").build();
        InvalidValueException e =
                assertThrows(InvalidValueException.class, () -> RenderWorker.run("127.0.0.1", 1, options, () -> false));
        assertEquals("device", e.key());
    }

    /** Counters are what a device does otherwise; no audit of others finds fault with them. */
    @Test
    void otherCountersAreNoOtherPicture() throws Exception {
        ServerOptions.Builder options = Farm.options().auditRate(1).awaitWorkers(2, Farm.TIMEOUT_SECONDS);
        AtomicInteger changed = new AtomicInteger();
        WorkerJobs.Tamper countsMore = (tile, bytes) -> {
            changed.incrementAndGet();
            // The second number of a result: its camera rays.
            ByteBuffer numbers = ByteBuffer.wrap(bytes);
            numbers.putLong(8, numbers.getLong(8) + 1);
            return bytes;
        };
        try (Farm farm = new Farm(options).begin()) {
            farm.join(Farm.worker(1).machine("other").tamper(countsMore));
            farm.join(Farm.worker(1).machine("one"));
            assertTrue(farm.result().complete());
            assertArrayEquals(ALONE, Farm.png(farm.result().image()));
            assertTrue(farm.server.audits().isComplete());
        }
        assertTrue(changed.get() > 0);
    }
}

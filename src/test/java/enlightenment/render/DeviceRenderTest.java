package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.checkpoint.Checkpoint;
import enlightenment.device.OpenClDriver;
import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import enlightenment.net.parts.RenderParts;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole renders in which a device takes part; skipped where no driver for OpenCL is installed. */
class DeviceRenderTest {
    @TempDir
    Path folder;

    @BeforeAll
    static void find() {
        OpenClDriver.assume();
    }

    /** The second scene has a pass of light paths, which the threads of the device make as the others do. */
    @ParameterizedTest
    @ValueSource(strings = {"cornell-box", "fire-and-ice-physical"})
    void aRenderWithADeviceMakesTheSamePicture(String name) throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        RenderSettings settings =
                RenderSettings.of(scene).toBuilder().size(64, 32).antialias(2).build();
        RenderRequest request = RenderRequest.of(scene, settings);
        assertArrayEquals(
                Renderer.render(request).image().toArray(),
                Renderer.render(request.withDevice("opencl")).image().toArray());
    }

    /** What is kept of it is gone on from without a device, and the other way round. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRenderThatIsKeptGoesOnWithAndWithoutADevice(boolean deviceFirst) throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", "cornell-box.json"));
        RenderSettings settings =
                RenderSettings.of(scene).toBuilder().size(64, 48).antialias(2).build();
        Path file = folder.resolve("kept.checkpoint");
        AtomicInteger calls = new AtomicInteger();
        RenderProgress few = (done, all, image) -> calls.incrementAndGet();
        RenderRequest request = RenderRequest.of(scene, settings);
        RenderRequest stopped = request.withProgress(few).withCancelled(() -> calls.get() > 3);
        boolean isWhole;
        RenderIdentity identity = new RenderIdentity(ContentHash.of(new byte[1]), "cornell box", "1");
        try (Checkpoint first = Checkpoint.open(file, identity, false)) {
            isWhole = Renderer.render(device(stopped, deviceFirst).withArchives(List.of(first)))
                    .complete();
        }
        assertFalse(isWhole);
        try (Checkpoint second = Checkpoint.open(file, identity, true)) {
            assertArrayEquals(
                    Renderer.render(request).image().toArray(),
                    Renderer.render(device(request, !deviceFirst).withArchives(List.of(second)))
                            .image()
                            .toArray());
        }
    }

    private static RenderRequest device(RenderRequest request, boolean with) {
        return request.withDevice(with ? "opencl" : "cpu");
    }

    /** A tile is compared with that of another part by its picture, not by what was tested for it. */
    @Test
    void partsByADeviceAndByTheProcessorGoTogether() throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", "fire-and-ice.json"));
        RenderSettings settings =
                RenderSettings.of(scene).toBuilder().size(64, 32).antialias(2).build();
        RenderRequest request = RenderRequest.of(scene, settings);
        List<Path> files = new ArrayList<>();
        for (String device : List.of("opencl", "cpu")) {
            Path file = folder.resolve(device + ".film");
            assertTrue(RenderParts.render(request.withDevice(device), 1, 1, n -> Map.of(), file));
            files.add(file);
        }
        assertArrayEquals(
                Renderer.render(request).image().toArray(),
                RenderParts.merge(files, Optional.empty()).result().image().toArray());
    }
}

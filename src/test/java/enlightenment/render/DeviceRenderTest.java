package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import enlightenment.device.DeviceFailure;
import enlightenment.device.opencl.OpenClDevices;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whole renders in which a device takes part; skipped where no driver for OpenCL is installed. */
class DeviceRenderTest {
    @BeforeAll
    static void find() {
        boolean isAvailable = false;
        try {
            isAvailable = OpenClDevices.all().stream().anyMatch(d -> d.problem().isEmpty());
        } catch (DeviceFailure e) {
            // None.
        }
        assumeTrue(isAvailable, "no driver for OpenCL is installed");
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
}

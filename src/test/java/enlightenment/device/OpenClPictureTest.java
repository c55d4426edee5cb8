package enlightenment.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of devices have the bits of the processor's. Skipped where no driver for OpenCL is installed. */
class OpenClPictureTest {
    private static final int FEW = 40;
    private static final int MANY = 1000;

    private static List<ComputeDevice> devices = List.of();

    @BeforeAll
    static void find() {
        devices = OpenClDriver.assume();
    }

    /** Renders a scene on every device, and returns the share of samples that devices shaded. */
    private static double assertSameBits(String name, Scene scene, RenderSettings settings) {
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        assertEquals(Optional.empty(), DeviceScene.refusal(compiled), name);
        FilmTile expected = TilePair.onProcessor(compiled, settings);
        double done = 0;
        for (ComputeDevice device : devices) {
            DeviceScene flat = DeviceScene.of(compiled, settings);
            try (DeviceProgram program = device.compile(flat.program());
                    DeviceKernel kernel = program.prepare(flat)) {
                ShadedSamples shaded = new ShadedSamples();
                DeviceTileShader shader =
                        new DeviceTileShader(compiled, settings, TilePair.counters(compiled), kernel, shaded, e -> {
                            throw e;
                        });
                FilmTile found = TilePair.by(shader, compiled, settings);
                assertEquals(0, TilePair.differences(expected, found), name + " on " + device.name());
                done += shaded.device() / (double) (shaded.device() + shaded.host());
            }
        }
        return done / devices.size();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"fire-and-ice", "bounce", "cone", "cube", "cylinders", "glass", "keyhole", "cornell-box", "chess"
            })
    void aShippedSceneHasTheSameBits(String name) throws IOException {
        Scene scene = SceneReader.read(Path.of("scenes", name + ".json"));
        RenderSettings settings =
                RenderSettings.of(scene).toBuilder().size(120, 60).antialias(2).build();
        assertTrue(assertSameBits(name, scene, settings) > 0.98, "the device does nearly all");
    }

    @Test
    void anySceneOfClassicShadingHasTheSameBits() {
        assertSameBits(RandomScene::classic, FEW);
    }

    @Test
    void anySceneOfPhysicalShadingHasTheSameBits() {
        assertSameBits(RandomScene::physical, FEW);
    }

    @Test
    @Tag("full")
    void aThousandScenesOfClassicShadingHaveTheSameBits() {
        assertSameBits(RandomScene::classic, MANY);
    }

    @Test
    @Tag("full")
    void aThousandScenesOfPhysicalShadingHaveTheSameBits() {
        assertSameBits(RandomScene::physical, MANY);
    }

    private static void assertSameBits(LongFunction<Scene> scenes, int count) {
        double done = 0;
        for (int seed = 0; seed < count; seed++) {
            Scene scene = scenes.apply(seed);
            RenderSettings settings =
                    RenderSettings.of(scene).toBuilder().antialias(2).build();
            CompiledScene compiled = SceneCompiler.compile(scene, settings);
            if (DeviceScene.refusal(compiled).isEmpty()) {
                done += assertSameBits("scene " + seed, scene, settings);
            }
        }
        assertTrue(done > 0.5 * count, "devices shade most of it: " + done);
    }
}

package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Blocks of all materials on a coarse grid, so that faces of theirs lie in one another in all ways there are: in a white furnace, where
 * nothing absorbs light, none of them shows.
 */
class FurnaceOfBlocksTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;

    private final RandomBlocks blocks = new RandomBlocks(14);

    private Scene scene() {
        Scene.Builder builder = PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1.2, -5), at(0, 0.8, 0), Vec3.Y, 40))
                .shading(PhysicalScenes.atMost(200, 1))
                .object(TestScenes.rectangle(-6, 0, -6, -6, 0, 6, 6, 0, 6, 6, 0, -6), matte(1, 1, 1));
        for (int k = 2 + blocks.random.nextInt(4); k > 0; k--) {
            builder.object(blocks.shape(), blocks.material());
        }
        return builder.build();
    }

    private void assertWhite(BuiltInMethod method, int scenes, int antialias, double tolerance) {
        for (int k = 0; k < scenes; k++) {
            Scene scene = scene();
            double mean = mean(scene, method, antialias, 1);
            if (Math.abs(mean - 1) > tolerance) {
                // Rough glass around a medium has few bright paths: whether it is they is seen with more of them.
                mean = mean(scene, method, 4 * antialias, 2);
            }
            assertEquals(1, mean, tolerance, "scene " + k + ": " + scene.objects());
        }
    }

    private static double mean(Scene scene, BuiltInMethod method, int antialias, long seed) {
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(method)
                .withAntialias(antialias)
                .withSeed(seed);
        return Rendered.mean(scene, settings);
    }

    /** What roulette leaves, and what tables of rough glass are off by, is below the tolerance. */
    @ParameterizedTest
    @CsvSource({"RAYTRACE, 60", "BIDIRECTIONAL, 30", "CLUSTER, 20"})
    void blocksThatTouchInAllWaysDoNotShow(BuiltInMethod method, int scenes) {
        assertWhite(method, scenes, 8, 0.01);
    }

    @Tag("full")
    @ParameterizedTest
    @CsvSource({"RAYTRACE, 1000", "BIDIRECTIONAL, 300", "CLUSTER, 300"})
    void aThousandScenesOfBlocksDoNotShow(BuiltInMethod method, int scenes) {
        assertWhite(method, scenes, 12, 0.005);
    }
}

package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Lamps and blocks of all materials on a coarse grid, so that they lie on one another in all ways there are: methods that find light in
 * different ways show the same.
 */
class LampsAmongBlocksTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 8;

    private final RandomBlocks blocks = new RandomBlocks(19);

    private Rgb radiance() {
        return Rgb.gray(1 << blocks.random.nextInt(4));
    }

    /** A rectangle across one of the axes, that shines to one side or to both. */
    private Light lamp() {
        int across = blocks.random.nextInt(3);
        double[] from = {blocks.grid(-2, 4), blocks.grid(0, 3), blocks.grid(-2, 4)};
        double[] to = from.clone();
        int u = (across + 1) % 3;
        int v = (across + 2) % 3;
        to[u] += blocks.grid(1, 3);
        to[v] += blocks.grid(1, 3);
        boolean isTurned = blocks.random.nextBoolean();
        double[] second = from.clone();
        double[] last = from.clone();
        second[isTurned ? u : v] = to[isTurned ? u : v];
        last[isTurned ? v : u] = to[isTurned ? v : u];
        return new Light.Rectangle(
                at(from[0], from[1], from[2]),
                at(second[0], second[1], second[2]),
                at(to[0], to[1], to[2]),
                at(last[0], last[1], last[2]),
                Rgb.WHITE,
                blocks.random.nextBoolean(),
                Emission.radiance(radiance()));
    }

    /** A room whose wall is the inside of a box. */
    private Scene scene(int fewest) {
        Scene.Builder builder = PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0.2, 1.3, -2.8), at(0, 0.8, 0), Vec3.Y, 60))
                .object(new Box(at(-3, 0, -3), at(3, 3, 3)), matte(0.6, 0.6, 0.6));
        for (int k = 1 + blocks.random.nextInt(3); k > 0; k--) {
            builder.object(blocks.shape(), blocks.material());
        }
        for (int k = blocks.random.nextInt(3); k > 0; k--) {
            builder.object(blocks.shape(), matte(0.5, 0.5, 0.5).withRadiance(radiance()));
        }
        for (int k = fewest + blocks.random.nextInt(3); k > 0; k--) {
            builder.light(lamp());
        }
        return builder.build();
    }

    private static double mean(Scene scene, BuiltInMethod method, int antialias) {
        return Rendered.mean(scene, RenderSettings.of(scene).withMethod(method).withAntialias(antialias));
    }

    private void assertSame(BuiltInMethod method, int scenes, int fewest, double tolerance) {
        for (int k = 0; k < scenes; k++) {
            Scene scene = scene(fewest);
            double expected;
            double mean;
            int antialias = 4;
            // Where few paths carry the light, more are followed.
            do {
                antialias *= 2;
                expected = mean(scene, BuiltInMethod.RAYTRACE, antialias);
                mean = mean(scene, method, antialias);
            } while (antialias < 64 && Math.abs(mean - expected) > tolerance * expected);
            // Exactly black where all lamps are in opaque blocks.
            assertEquals(expected, mean, tolerance * expected, "scene " + k + ": " + scene.objects() + scene.lights());
        }
    }

    @ParameterizedTest
    @CsvSource({"BIDIRECTIONAL, 30, 1", "BIDIRECTIONAL, 10, 20", "CLUSTER, 10, 1"})
    void lampsThatTouchBlocksInAllWaysGiveTheSameLightByAllMethods(BuiltInMethod method, int scenes, int fewest) {
        assertSame(method, scenes, fewest, 0.03);
    }

    @Tag("full")
    @ParameterizedTest
    @CsvSource({"BIDIRECTIONAL, 300, 1", "BIDIRECTIONAL, 50, 20", "CLUSTER, 50, 1"})
    void hundredsOfScenesOfLampsGiveTheSameLightByAllMethods(BuiltInMethod method, int scenes, int fewest) {
        assertSame(method, scenes, fewest, 0.015);
    }
}

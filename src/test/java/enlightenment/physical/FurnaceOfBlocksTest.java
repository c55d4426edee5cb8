package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneBuilder;
import java.util.OptionalDouble;
import java.util.Random;
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

    private final Random random;

    FurnaceOfBlocksTest() {
        random = new Random(14);
    }

    private double grid(int from, int steps) {
        return 0.5 * (from + random.nextInt(steps));
    }

    private Material material() {
        int priority = random.nextInt(3) == 0 ? 1 : 0;
        return switch (random.nextInt(8)) {
            case 0 -> Material.Matte.of(linear(1, 1, 1)).withRoughness(random.nextBoolean() ? 0 : 0.8);
            case 1 -> Material.Mirror.of(linear(1, 1, 1));
            case 2 -> glass(random.nextBoolean() ? 1.5 : 1.3, 0, priority);
            case 3 -> glass(1.5, 0.5, priority);
            case 4 -> glass(1, 0, priority);
            case 5 -> fog(1, 0, priority);
            case 6 -> fog(1.4, random.nextBoolean() ? 0 : 0.4, priority);
            default -> Material.Glossy.of(linear(1, 1, 1), 0.5);
        };
    }

    private static Material glass(double index, double roughness, int priority) {
        return new Material.Glass(
                linear(1, 1, 1), index, 1, priority, true, roughness, Rgb.BLACK, true, OptionalDouble.empty());
    }

    private static Material fog(double index, double roughness, int priority) {
        return new Material.Scattering(Medium.Coefficients.of(Rgb.gray(1), Rgb.BLACK), index, roughness, priority);
    }

    private Shape block() {
        double y = grid(0, 2);
        if (random.nextInt(3) == 0) {
            return new Cylinder(at(0, y, 0), at(0, y + grid(1, 2), 0), grid(1, 2), true);
        }
        double x = grid(-2, 4);
        double z = grid(-2, 4);
        return new Box(at(x, y, z), at(x + grid(1, 3), y + grid(1, 2), z + grid(1, 3)));
    }

    private Scene scene() {
        SceneBuilder builder = PhysicalScenes.view(WIDTH, HEIGHT)
                .camera(new Camera.Perspective(at(0, 1.2, -5), at(0, 0.8, 0), Vec3.Y, 40))
                .shading(PhysicalScenes.atMost(200, 1))
                .object(TestScenes.rectangle(-6, 0, -6, -6, 0, 6, 6, 0, 6, 6, 0, -6), matte(1, 1, 1));
        for (int k = 2 + random.nextInt(4); k > 0; k--) {
            builder.object(block(), material());
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

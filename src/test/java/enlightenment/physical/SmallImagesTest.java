package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.material.Glass;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lamps whose images are smaller than a pixel, seen with nothing in between: no picture may miss them, and none may see them twice. */
class SmallImagesTest {
    private static final int SMALL = 4;
    private static final int ZOOM = 128;
    private static final Camera EYE = new Camera.Perspective(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 40);
    private static final Camera FAR = new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 16);

    /** Three lamps, half of one of them hidden. */
    private static Scene lamps() {
        return withLamps(EYE)
                .object(TestScenes.rectangle(1.0 / 6, -1, 5, 1.0 / 6, 1, 5, 0.5, 1, 5, 0.5, -1, 5), matte(0, 0, 0))
                .build();
    }

    private static Scene.Builder withLamps(Camera camera) {
        return Scene.builder()
                .size(SMALL, SMALL)
                .shading(shading(0))
                .camera(camera)
                .light(sphereLight(1, 1, 30, 0.5, 900))
                .light(sphereLight(-4, 3, 25, 0.6, 700))
                .light(sphereLight(3, -2.5, 20, 0.2, 900));
    }

    /** The mean over the pixels that another picture has for one. */
    private static double mean(Image image, int zoom, int column, int row, int band) {
        double sum = 0;
        for (int y = zoom * row; y < zoom * (row + 1); y++) {
            for (int x = zoom * column; x < zoom * (column + 1); x++) {
                sum += image.component(x, y, band);
            }
        }
        return sum / (zoom * zoom);
    }

    private static void assertSame(Image large, Image small, double tolerance) {
        int lit = 0;
        for (int k = 0; k < SMALL * SMALL; k++) {
            for (int band = 0; band < 3; band++) {
                double expected = mean(large, ZOOM, k % SMALL, k / SMALL, band);
                double actual = small.component(k % SMALL, k / SMALL, band);
                assertEquals(expected, actual, tolerance * Math.max(expected, 1), "pixel " + k + ", band " + band);
                lit += expected > 1 ? 1 : 0;
            }
        }
        assertTrue(lit >= 3, "of " + lit);
    }

    /** In the larger picture each image covers many pixels, and camera rays alone find it. */
    @Test
    void theMeanOfAPictureIsTheSameHoweverSmallTheImagesOfLampsAre() {
        Scene scene = lamps();
        Image large = Rendered.zoomed(scene, ZOOM, 16, BuiltInMethod.RAYTRACE, 1);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            assertSame(large, Rendered.zoomed(scene, 1, 1 << 13, method, 2), 0.04);
        }
    }

    /**
     * One pixel, half of whose rays start within glass that the film cuts: images are sampled apart where rays start outside of it only, from
     * whichever half a sample's own ray comes. In a larger picture no image is smaller than a pixel.
     */
    @ParameterizedTest
    @CsvSource({"0.32, 0.25", "-0.32, 0.25", "0.02, 0.25"})
    void lampsCountOnceWhereTheFilmCutsGlass(double lampX, double lampY) {
        Scene scene = Scene.builder()
                .size(1, 1)
                .shading(shading(0))
                .camera(new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 2))
                .object(new Box(at(-5, -5, -1), at(0, 5, 1)), Glass.of(PhysicalScenes.linear(1, 0.9, 0.8), 1.5))
                .light(sphereLight(lampX, lampY, 4.95, 0.05, 1000))
                .build();
        double expected = mean(Rendered.zoomed(scene, ZOOM, 64, BuiltInMethod.RAYTRACE, 1), ZOOM, 0, 0, 0);
        for (BuiltInMethod method : List.of(BuiltInMethod.RAYTRACE, BuiltInMethod.BIDIRECTIONAL)) {
            double actual = Rendered.zoomed(scene, 1, 1 << 16, method, 2).component(0, 0, 0);
            assertEquals(expected, actual, 0.05 * expected, method.word());
        }
    }

    @Test
    void theSameHoldsForParallelRays() {
        Scene scene = withLamps(FAR).build();
        Image large = Rendered.zoomed(scene, ZOOM, 4, BuiltInMethod.RAYTRACE, 1);
        assertSame(large, Rendered.zoomed(scene, 1, 1 << 13, BuiltInMethod.RAYTRACE, 2), 0.04);
    }

    /** An image smaller than a hundredth of a pixel: four samples of the pixel itself would seldom meet it. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void fewSamplesFindEachLamp(long seed) {
        Scene scene = lamps();
        Image exact = Rendered.zoomed(scene, 1, 1 << 14, BuiltInMethod.RAYTRACE, 2);
        Image few = Rendered.zoomed(scene, 1, 8, BuiltInMethod.RAYTRACE, seed);
        for (int k = 0; k < SMALL * SMALL; k++) {
            double expected = exact.component(k % SMALL, k / SMALL, 0);
            double actual = few.component(k % SMALL, k / SMALL, 0);
            assertTrue(actual >= 0.2 * expected - 0.1 && actual <= 3 * expected + 0.1, actual + " for " + expected);
        }
    }

    /** What a pixel's second places are is a function of the pixel, wherever tiles end. */
    @Test
    void aCropHasTheBytesOfTheWholePicture() throws Exception {
        Scene scene = SceneReader.read(Path.of("scenes/fire-and-ice-physical.json"));
        RenderSettings settings =
                RenderSettings.of(scene).withSize(48, 24).withBudget(RenderSettings.Budget.NONE.withSamples(4));
        Image whole = Renderer.render(scene, settings);
        Image part = Renderer.render(scene, settings.withCrop(new RenderSettings.Crop(23, 7, 9, 5)));
        for (int y = 0; y < 5; y++) {
            for (int x = 0; x < 9; x++) {
                assertArrayEquals(
                        new double[] {
                            whole.component(23 + x, 7 + y, 0),
                            whole.component(23 + x, 7 + y, 1),
                            whole.component(23 + x, 7 + y, 2)
                        },
                        new double[] {part.component(x, y, 0), part.component(x, y, 1), part.component(x, y, 2)});
            }
        }
    }
}

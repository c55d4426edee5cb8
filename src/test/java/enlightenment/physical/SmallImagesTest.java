package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.image.Image;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.Budget;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneBuilder;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Lamps whose images are smaller than a pixel, straight and in mirrors: no picture may miss them, and none may see them twice. */
class SmallImagesTest {
    private static final int SMALL = 4;
    private static final int ZOOM = 128;
    private static final Camera EYE = new Camera.Perspective(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 40);
    private static final Camera FAR = new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 16);

    /** A lamp before the eye, half of it hidden, and one behind it, which a flat mirror and a ball show. */
    private static Scene lamps() {
        return withLamps(EYE)
                .object(TestScenes.rectangle(1.0 / 6, -1, 5, 1.0 / 6, 1, 5, 0.5, 1, 5, 0.5, -1, 5), matte(0, 0, 0))
                .object(ball(-5, 4, 20, 3), mirror())
                .build();
    }

    private static SceneBuilder withLamps(Camera camera) {
        return Scene.builder()
                .size(SMALL, SMALL)
                .shading(shading(0))
                .camera(camera)
                .object(TestScenes.rectangle(0.5, -4, 15, 0.5, -0.5, 15, 4, -0.5, 15, 4, -4, 15), mirror())
                .light(sphereLight(1, 1, 30, 0.5, 900))
                .light(sphereLight(3, -2.5, -10, 1, 700));
    }

    private static Material mirror() {
        return Material.Mirror.of(Texture.of(new Rgb(0.9, 0.7, 0.5)));
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
     * A box and a ball of glass reflect some hundredths of a lamp behind the eye. With one event nothing comes through. In the flat face it
     * is seen in the distance d at the angle a, at both of which Fresnel's share hardly differs from that at right angles: a pixel of side
     * s has L R Ω / (s² cos³ a).
     */
    @Test
    void glassReflectsLampsOnce() {
        Material glass = Material.Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5);
        Scene scene = Scene.builder()
                .size(SMALL, SMALL)
                .shading(PhysicalScenes.atMost(1, 0))
                .camera(EYE)
                .object(new Box(at(0.5, -4, 15), at(4, -0.5, 16)), glass)
                .object(ball(-5, 4, 20, 3), glass)
                .light(sphereLight(3, -2.5, -10, 1, 9000))
                .light(sphereLight(-2, 1, -10, 1, 20_000))
                .build();
        double d = new Vec3(3, -2.5, 40).length();
        double side = 2 * Math.tan(Math.toRadians(20)) / SMALL;
        double angle = Math.PI / (d * d);
        double expected = 9000 * 0.04 * angle / (side * side * Math.pow(40 / d, 3));
        double inBall =
                Rendered.zoomed(scene, 1, 1 << 13, BuiltInMethod.RAYTRACE, 1).component(0, 0, 0);
        assertTrue(inBall > 0.5, "seen in the ball: " + inBall);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            Image picture = Rendered.zoomed(scene, 1, 1 << 13, method, 2);
            assertEquals(expected, picture.component(2, 2, 0), 0.03 * expected, method.word());
            assertEquals(inBall, picture.component(0, 0, 0), 0.05 * inBall, method.word());
        }
    }

    /**
     * The same of a pane, both of whose faces reflect, to and fro: R = 2F/(1 + F), F = 0.04. Glass that is opaque in part reflects less, and
     * is black otherwise. Few samples are enough.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.25})
    void panesReflectLampsOnce(double transparency) {
        Material pane = new Material.Glass(
                Texture.of(new Rgb(1e-9, 1e-9, 1e-9)),
                1.5,
                transparency,
                0,
                true,
                0,
                Rgb.BLACK,
                true,
                OptionalDouble.empty());
        Scene scene = Scene.builder()
                .size(SMALL, SMALL)
                .shading(PhysicalScenes.atMost(1, 0))
                .camera(EYE)
                .object(TestScenes.rectangle(0.5, -4, 15, 0.5, -0.5, 15, 4, -0.5, 15, 4, -4, 15), pane)
                .light(sphereLight(3, -2.5, -10, 1, 9000))
                .build();
        double d = new Vec3(3, -2.5, 40).length();
        double side = 2 * Math.tan(Math.toRadians(20)) / SMALL;
        double share = transparency * 2 * 0.04 / 1.04;
        double expected = 9000 * share * Math.PI / (d * d) / (side * side * Math.pow(40 / d, 3));
        for (BuiltInMethod method : BuiltInMethod.values()) {
            Image picture = Rendered.zoomed(scene, 1, 64, method, 2);
            assertEquals(expected, picture.component(2, 2, 0), 0.03 * expected, method.word());
        }
    }

    /** Four faces of tinted panes before a lamp, two of them of one tube, each of which lets 1 − R of its colour pass: R = 2F/(1 + F), F = 0.04. */
    @Test
    void lampsAreSeenThroughPanesWithFewSamples() {
        Material pane = Material.Glass.of(PhysicalScenes.linear(0.8, 0.6, 0.5), 1.5);
        Scene scene = Scene.builder()
                .size(SMALL, SMALL)
                .shading(PhysicalScenes.atMost(1, 0))
                .camera(EYE)
                .object(TestScenes.rectangle(-9, -9, 5, -9, 9, 5, 9, 9, 5, 9, -9, 5), pane)
                .object(TestScenes.rectangle(-9, -9, 8, -9, 9, 8, 9, 9, 8, 9, -9, 8), pane)
                .object(new Cylinder(at(-30, 1, 20), at(30, 1, 20), 2, false), pane)
                .light(sphereLight(1, 1, 30, 0.05, 1e6))
                .build();
        double d = new Vec3(1, 1, 30).length();
        double side = 2 * Math.tan(Math.toRadians(20)) / SMALL;
        double clear = 1 - 2 * 0.04 / 1.04;
        double white = 1e6 * Math.pow(clear, 4) * Math.PI * 0.05 * 0.05 / (d * d) / (side * side * Math.pow(30 / d, 3));
        for (BuiltInMethod method : BuiltInMethod.values()) {
            Image picture = Rendered.zoomed(scene, 1, 64, method, 2);
            for (int band = 0; band < 3; band++) {
                double color = band == 0 ? 0.8 : band == 1 ? 0.6 : 0.5;
                double expected = Math.pow(color, 4) * white;
                assertEquals(expected, picture.component(2, 1, band), 0.03 * expected, method.word());
            }
        }
    }

    /** What is half covered by an image is seen by both ways, and counts once: the lamp fills some tenths of a pixel. */
    @Test
    void lampsBehindPanesCountOnce() {
        Material pane = new Material.Glass(
                PhysicalScenes.linear(0.8, 0.6, 0.5), 1.5, 0.7, 0, true, 0, Rgb.BLACK, true, OptionalDouble.empty());
        Scene scene = Scene.builder()
                .size(SMALL, SMALL)
                .shading(PhysicalScenes.atMost(1, 0))
                .camera(EYE)
                .object(TestScenes.rectangle(-9, -9, 5, -9, 9, 5, 9, 9, 5.5, 9, -9, 5.5), pane)
                .light(sphereLight(1, 1, 30, 1.5, 20))
                .light(sphereLight(-4, -3, 28, 1, 30))
                .build();
        Image large = Rendered.zoomed(scene, ZOOM, 16, BuiltInMethod.RAYTRACE, 1);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            if (method != BuiltInMethod.LIGHT) {
                assertSame(large, Rendered.zoomed(scene, 1, 1 << 12, method, 2), 0.02);
            }
        }
    }

    static Stream<Arguments> curvedMirrors() {
        return Stream.of(
                arguments("cylinder", EYE, new Cylinder(at(3, -2, 14), at(3.2, 3, 14.5), 1.5, true), 1),
                arguments("cylinder, parallel rays", FAR, new Cylinder(at(3, -2, 14), at(3.2, 3, 14.5), 1.5, true), 1),
                // Whose base lies on the floor, where nothing else is seen of it.
                arguments("cylinder on the floor", EYE, new Cylinder(at(3, -4, 15), at(3, 3, 15), 1.5, true), 1),
                arguments("cone", EYE, new Cone(at(3, -2, 15), at(3, 4, 15), 2, 1.5, true), 1),
                arguments("cone, parallel rays", FAR, new Cone(at(3, -2, 15), at(3, 4, 15), 2, 1.7, true), 1),
                arguments("ball, parallel rays", FAR, new Sphere(at(3, 2, 15), 2, 0), 1),
                arguments("torus", EYE, new Torus(at(0, 0, 15), new Vec3(0.2, 0.3, 1), 3.5, 1), 2),
                arguments("torus, parallel rays", FAR, new Torus(at(0, 0, 15), new Vec3(0.2, 0.3, 1), 4, 1), 2));
    }

    /** A large picture, in which camera rays alone find the lamp, and a small one with few samples; each ray is reflected once. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("curvedMirrors")
    void curvedMirrorsShowLampsWithFewSamples(String name, Camera camera, Shape shape, int images) {
        Scene scene = Scene.builder()
                .size(SMALL, SMALL)
                .shading(PhysicalScenes.atMost(1, 0))
                .camera(camera)
                .object(TestScenes.rectangle(-9, -4, 5, -9, -4, 30, 9, -4, 30, 9, -4, 5), matte(0, 0, 0))
                .object(shape, mirror())
                .light(sphereLight(5, 5, -10, 0.4, 100_000))
                .build();
        Image large = Rendered.zoomed(scene, ZOOM, 16, BuiltInMethod.RAYTRACE, 1);
        Image small = Rendered.zoomed(scene, 1, 256, BuiltInMethod.RAYTRACE, 2);
        assertEquals(0, off(large, small, images), 0.1, "is off");
    }

    private static Material glass(double transparency, double... absorption) {
        Rgb absorbed = absorption.length == 0 ? Rgb.BLACK : new Rgb(absorption[0], absorption[1], absorption[2]);
        return new Material.Glass(
                PhysicalScenes.linear(1, 0.9, 0.8),
                1.5,
                transparency,
                0,
                true,
                0,
                absorbed,
                true,
                OptionalDouble.empty());
    }

    private static Arguments chains(String name, Camera camera, int lit, Object... shapesAndMaterials) {
        SceneBuilder builder = Scene.builder()
                .size(SMALL, SMALL)
                .shading(shading(0))
                .camera(camera)
                .light(sphereLight(1.1, 0.7, 40, 0.1, 1e6));
        for (int k = 0; k < shapesAndMaterials.length; k += 2) {
            builder.object((Shape) shapesAndMaterials[k], (Material) shapesAndMaterials[k + 1]);
        }
        return arguments(name, builder.build(), lit);
    }

    /** Each with one lamp, by the way of chains of events that the name tells. */
    static Stream<Arguments> longChains() {
        Shape front = TestScenes.rectangle(-9, -9, 50, -9, 9, 50, 9, 9, 50, 9, -9, 50);
        Shape back = TestScenes.rectangle(-19, -19, -5, -19, 19, -5, 19, 19, -5, 19, -19, -5);
        Shape floor = TestScenes.rectangle(-9, -3, 5, -9, -3, 60, 9, -3, 60, 9, -3, 5);
        Shape cylinder = new Cylinder(at(-3, 0.3, 15), at(3, 0.9, 17), 2, true);
        return Stream.of(
                chains("a cylinder of glass", EYE, 1, cylinder, glass(1)),
                chains("absorbing glass, clear in part", EYE, 1, cylinder, glass(0.5, 0.2, 0.4, 0.1)),
                chains("parallel rays", FAR, 1, cylinder, glass(1)),
                chains("a ball of glass over a mirror", EYE, 2, ball(1, 0, 20, 2), glass(1), floor, mirror()),
                chains("a slanted box of glass", EYE, 1, new Box(at(-3, -2, 12), at(3, 4, 17)), glass(1)),
                chains("a ring of glass", EYE, 2, new Torus(at(0, 0, 15), new Vec3(0.2, 0.3, 1), 3, 1), glass(1)),
                chains("between two mirrors", EYE, 1, front, mirror(), back, mirror()),
                chains("two balls that reflect", EYE, 1, ball(-2, 0, 20, 2), mirror(), ball(3, 1, 15, 1), mirror()),
                chains(
                        "a pane before glass",
                        EYE,
                        1,
                        new Box(at(-3, -2, 12), at(3, 4, 17)),
                        glass(1),
                        TestScenes.rectangle(-9, -9, 5, -9, 9, 5, 9, 9, 6, 9, -9, 6),
                        Material.Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5)));
    }

    /** A large picture, in which camera rays alone find the lamp, and small ones with few samples. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("longChains")
    void glassAndSeveralMirrorsShowLampsWithFewSamples(String name, Scene scene, int least) {
        Image large = Rendered.zoomed(scene, ZOOM, 64, BuiltInMethod.RAYTRACE, 1);
        for (BuiltInMethod method : BuiltInMethod.values()) {
            // Chains of samples find one image after the other.
            int samples = method == BuiltInMethod.METROPOLIS ? 1 << 14 : 256;
            Image small = Rendered.zoomed(scene, 1, samples, method, 2);
            assertEquals(0, off(large, small, least), 0.1, method.word() + " is off");
        }
    }

    /** Which share of the light is elsewhere, or missing; fails where fewer pixels have any. */
    private static double off(Image large, Image small, int least) {
        double expected = 0;
        double off = 0;
        int lit = 0;
        for (int k = 0; k < SMALL * SMALL; k++) {
            double pixel = mean(large, ZOOM, k % SMALL, k / SMALL, 0);
            expected += pixel;
            lit += pixel > 0 ? 1 : 0;
            off += Math.abs(small.component(k % SMALL, k / SMALL, 0) - pixel);
        }
        assertTrue(lit >= least, lit + " pixels are lit");
        return off / expected;
    }

    /**
     * One pixel, half of whose rays start within glass that the film cuts: images are sampled apart where rays start outside of it only, from
     * whichever half a sample's own ray comes. In a larger picture no image is smaller than a pixel.
     */
    @ParameterizedTest
    @CsvSource({"0.3, 0.2, 0.32, 0.25", "-0.3, 0.2, -0.32, 0.25", "0.05, 0.2, 0.07, 0.25"})
    void lampsCountOnceWhereTheFilmCutsGlass(double ballX, double ballY, double lampX, double lampY) {
        Scene scene = Scene.builder()
                .size(1, 1)
                .shading(shading(0))
                .camera(new Camera.Orthographic(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 2))
                .object(new Box(at(-5, -5, -1), at(0, 5, 1)), glass(1))
                .object(ball(ballX, ballY, 4, 0.6), glass(1))
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
        RenderSettings settings = RenderSettings.of(scene).withSize(48, 24).withBudget(Budget.NONE.withSamples(4));
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
        // The mirror ball shows the lamp there, which is a hundredth of two pixels large.
        assertTrue(whole.component(23, 9, 0) > 0.8 && whole.component(24, 9, 0) > 0.8);
    }
}

package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Sphere;
import enlightenment.image.Image;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RendererTest {
    private static final Scene SMALL = TestScenes.whiteFireAndIce().size(80, 40).build();
    private static final RenderSettings QUICK = RenderSettings.of(SMALL)
            .withAntialias(2)
            .with(new BuiltInMethod.RayTraceSettings(4))
            .withThreads(1);

    @Test
    void theNumberOfThreadsDoesNotChangeABit() {
        float[] one = Renderer.render(SMALL, QUICK).toArray();
        for (int threads : new int[] {2, 7}) {
            assertArrayEquals(
                    one, Renderer.render(SMALL, QUICK.withThreads(threads)).toArray());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 16, 64})
    void theSizeOfTilesDoesNotChangeABit(int size) {
        float[] standard = Renderer.render(SMALL, QUICK).toArray();
        assertArrayEquals(
                standard, Renderer.render(SMALL, QUICK.withTileSize(size)).toArray());
    }

    @Test
    void aCropShowsThePixelsOfTheWhole() {
        Image whole = Renderer.render(SMALL, QUICK);
        Crop crop = new Crop(33, 5, 30, 21);
        Image part = Renderer.render(SMALL, QUICK.withCrop(crop));
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(whole.component(x + crop.x(), y + crop.y(), c), part.component(x, y, c));
                }
            }
        }
    }

    @Test
    void theOrderOfObjectsDoesNotChangeABit() {
        List<enlightenment.scene.SceneObject> shuffled = new ArrayList<>(SMALL.objects());
        Collections.shuffle(shuffled, new Random(7));
        Scene.Builder b = Scene.builder().size(80, 40).camera(SMALL.camera());
        SMALL.lights().forEach(b::light);
        shuffled.forEach(b::object);
        assertArrayEquals(
                Renderer.render(SMALL, QUICK).toArray(),
                Renderer.render(b.build(), QUICK).toArray());
    }

    @Test
    void theSeedChangesTheNoiseButNotThePicture() {
        Image a = Renderer.render(SMALL, QUICK);
        Image b = Renderer.render(SMALL, QUICK.withSeed(99));
        double difference = 0;
        double signed = 0;
        float[] p = a.toArray();
        float[] q = b.toArray();
        for (int i = 0; i < p.length; i++) {
            difference += Math.abs(p[i] - q[i]);
            signed += p[i] - q[i];
        }
        assertTrue(difference > 0);
        assertEquals(0, signed / p.length, 0.001);
    }

    @Test
    void parallelMirrorsSumAGeometricSeries() {
        // Between two mirrors of reflectance 1/2, looking straight into one: what is seen after n bounces is black, but
        // each pane of glass that stands between them adds its opaque share: a/(1 - r) summed as a series.
        double r = 0.5;
        double opaque = 0.25;
        Material pane = new Glass(Texture.of(DisplayRgb.WHITE), 1.5, 1 - opaque, 0, true);
        for (int limit : new int[] {1, 10, 1000, 100_000}) {
            Scene scene = Scene.builder()
                    .size(1, 1)
                    .camera(new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0, 1), Vec3.Y, 1))
                    .shading(new Shading.Classic(1, 1, DisplayRgb.BLACK, limit))
                    .object(panel(2), pane)
                    .object(panel(4), TestScenes.mirror(r))
                    .object(panel(-4), TestScenes.mirror(r))
                    .build();
            double expected = 0;
            double weight = 1;
            // The path runs pane, front mirror, pane, back mirror, pane, ...; panes are no bounces.
            for (int mirrors = 0; mirrors <= limit; mirrors++) {
                expected += weight * opaque;
                weight *= (1 - opaque) * r;
            }
            Image image = Renderer.render(scene, RenderSettings.of(scene).withAntialias(1));
            assertEquals((float) expected, image.component(0, 0, 1), 1e-7, "limit " + limit);
        }
    }

    private static Rectangle panel(double z) {
        return TestScenes.rectangle(-9, -9, z, -9, 9, z, 9, 9, z, 9, -9, z);
    }

    @Test
    void withoutLightsThereIsAmbientLightOnly() {
        for (double ambient : new double[] {0, 0.1}) {
            Scene scene = Scene.builder()
                    .size(4, 4)
                    .camera(new Camera.Perspective(ExactPoint.of(0, 0, 0), ExactPoint.of(0, 0, 1), Vec3.Y, 20))
                    .shading(new Shading.Classic(ambient, 0.5, DisplayRgb.BLACK, 10))
                    .object(panel(3), TestScenes.matte(1, 0.5, 0.25))
                    .build();
            Image image = Renderer.render(scene, RenderSettings.of(scene));
            assertEquals((float) ambient, image.component(1, 2, 0));
            assertEquals((float) (ambient * 0.5), image.component(1, 2, 1));
            assertEquals((float) (ambient * 0.25), image.component(1, 2, 2));
        }
    }

    @Test
    void glassOfIndexOneIsInvisible() {
        Scene without = SMALL;
        Scene.Builder b = Scene.builder().size(80, 40).camera(SMALL.camera());
        SMALL.objects().forEach(b::object);
        b.object(Sphere.of(ExactPoint.of(0.3, 1.2, 3), 0.9), new Glass(Texture.of(DisplayRgb.WHITE), 1, 1, 0, true));
        // Glass throws shadows in classic shading, so both scenes are lit by ambient light only.
        RenderSettings s = QUICK;
        Scene.Builder plain = Scene.builder().size(80, 40).camera(SMALL.camera());
        without.objects().forEach(plain::object);
        float[] p = Renderer.render(plain.build(), s).toArray();
        float[] q = Renderer.render(b.build(), s).toArray();
        assertArrayEquals(p, q, 1e-7f);
    }

    @Test
    void aGlassBallTurnsTheViewUpsideDown() {
        // A ball lens of index 1.5 and radius 1: seen from far, what lies behind it is upside down.
        Scene scene = Scene.builder()
                .size(64, 64)
                .camera(new Camera.Perspective(ExactPoint.of(0, 0, -20), ExactPoint.of(0, 0, 0), Vec3.Y, 12))
                .shading(new Shading.Classic(1, 1, DisplayRgb.BLACK, 10))
                .object(Sphere.of(ExactPoint.of(0, 0, 0), 1), Glass.of(Texture.of(DisplayRgb.WHITE), 1.5))
                .object(TestScenes.rectangle(-9, 0, 8, -9, 9, 8, 9, 9, 8, 9, 0, 8), TestScenes.matte(1, 0, 0))
                .object(TestScenes.rectangle(-9, -9, 8, -9, 0, 8, 9, 0, 8, 9, -9, 8), TestScenes.matte(0, 0, 1))
                .build();
        Image image = Renderer.render(scene, RenderSettings.of(scene));
        assertEquals(1, image.component(32, 22, 2), 1e-6, "blue is above, through the ball");
        assertEquals(1, image.component(32, 42, 0), 1e-6, "red is below, through the ball");
        assertEquals(1, image.component(1, 1, 0), 1e-6, "red is above, beside the ball");
        assertEquals(1, image.component(1, 62, 2), 1e-6, "blue is below, beside the ball");
    }

    @Test
    void lightsAreAveraged() {
        Light white = SMALL.lights().get(0);
        Scene.Builder twice = Scene.builder().size(80, 40).camera(SMALL.camera());
        SMALL.objects().forEach(twice::object);
        twice.light(new Light.Point(ExactPoint.of(0, 1, 1), DisplayRgb.WHITE))
                .light(new Light.Point(ExactPoint.of(0, 1, 1), DisplayRgb.WHITE));
        Scene.Builder once = Scene.builder().size(80, 40).camera(SMALL.camera());
        SMALL.objects().forEach(once::object);
        once.light(new Light.Point(ExactPoint.of(0, 1, 1), DisplayRgb.WHITE));
        assertArrayEquals(
                Renderer.render(once.build(), QUICK).toArray(),
                Renderer.render(twice.build(), QUICK).toArray(),
                1e-6f);
        assertTrue(white.reach() > 0);
    }

    @Test
    void progressReachesTheEndAndCancellingKeepsWhatIsDone() {
        AtomicInteger calls = new AtomicInteger();
        RenderResult all = Renderer.render(
                SMALL,
                QUICK.withTileSize(8),
                (done, total, image) -> {
                    assertTrue(done <= total);
                    calls.incrementAndGet();
                },
                () -> false);
        assertEquals(50, calls.get());
        assertTrue(all.complete());
        AtomicInteger tiles = new AtomicInteger();
        RenderResult some = Renderer.render(
                SMALL, QUICK.withTileSize(8), (done, total, image) -> tiles.incrementAndGet(), () -> tiles.get() >= 10);
        assertFalse(some.complete());
        assertEquals(all.image().component(2, 2, 0), some.image().component(2, 2, 0));
        assertEquals(640, some.report().pixels());
    }

    @Test
    void anImpossibleSizeIsRefused() {
        InvalidValueException e =
                assertThrows(InvalidValueException.class, () -> Renderer.render(SMALL, QUICK.withSize(65536, 65536)));
        assertTrue(e.getMessage().contains("bytes"), e.getMessage());
    }

    @Test
    void anEmptySceneShowsItsBackground() {
        Scene scene = Scene.builder()
                .size(3, 2)
                .camera(SMALL.camera())
                .shading(new Shading.Classic(0.5, 0.5, new DisplayRgb(0.25, 0.5, 0.75), 10))
                .build();
        Image image = Renderer.render(scene, RenderSettings.of(scene));
        assertEquals(0.25f, image.component(0, 0, 0));
        assertEquals(0.5f, image.component(2, 1, 1));
        assertEquals(0.75f, image.component(1, 0, 2));
    }

    @Test
    void aSceneTimesAPowerOfTwoGivesTheSameBits() {
        float[] unit = Renderer.render(scaled(0), QUICK).toArray();
        for (int k : new int[] {-900, -300, -60, -1, 1, 60, 300, 900}) {
            assertArrayEquals(unit, Renderer.render(scaled(k), QUICK).toArray(), "k = " + k);
        }
    }

    private static Scene scaled(int k) {
        Scene.Builder b = Scene.builder()
                .size(80, 40)
                .camera(new Camera.Window(
                        p(k, 0, 1, -3), p(k, -3, 0, 0), p(k, -3, 3, 0), p(k, 3, 3, 0), p(k, 3, 0, 0), 0))
                .object(new Sphere(p(k, -2, 1, 4), Math.scalb(1.5, k), 0), TestScenes.matte(1, 1, 1))
                .object(new Sphere(p(k, 0.125, 3, 4), Math.scalb(0.7, k), 0), TestScenes.mirror(0.9))
                .object(
                        new Sphere(p(k, 1.75, 1, 3), Math.scalb(1.0, k), 0),
                        Glass.of(Texture.of(new DisplayRgb(1, 0.9, 0.9)), 1.5))
                .object(
                        new Rectangle(p(k, -6, -1, -2), p(k, -6, -1, 8), p(k, 6, -1, 8), p(k, 6, -1, -2)),
                        TestScenes.matte(0.5, 0.7, 0.9))
                .object(
                        new Rectangle(p(k, -6, -6, 8), p(k, -6, 6, 9), p(k, 6, 6, 9), p(k, 6, -6, 8)),
                        TestScenes.matte(0.9, 0.7, 0.4))
                .light(new Light.Sphere(p(k, 0, 2, 1), Math.scalb(0.25, k), DisplayRgb.WHITE))
                .light(new Light.Rectangle(
                        p(k, -1, 5, 1), p(k, -1, 5, 2), p(k, 1, 5, 2), p(k, 1, 5, 1), DisplayRgb.WHITE));
        return b.build();
    }

    private static ExactPoint p(int k, double x, double y, double z) {
        return ExactPoint.of(Math.scalb(x, k), Math.scalb(y, k), Math.scalb(z, k));
    }

    @Test
    void threeLinesRenderAScene() {
        Scene scene = SMALL;
        Image image = Renderer.render(scene, RenderSettings.of(scene));
        assertEquals(80, image.width());
    }
}

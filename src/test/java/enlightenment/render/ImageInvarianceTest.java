package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.geometry.Sphere;
import enlightenment.math.ExactPoint;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.HierarchyChoice;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A picture depends neither on the unit of its scene nor on where the scene lies, nor on how the work is done (N01–N05). */
class ImageInvarianceTest {
    private static final int[] POWERS_OF_TWO = {-899, 900};
    private static final int[] MORE_POWERS_OF_TWO = {-900, -300, -60, -1, 1, 60, 300, 900};
    private static final int[] POWERS_OF_TEN = {-150, 1, 150};
    private static final int[] MORE_POWERS_OF_TEN = {-150, -9, -6, -3, 1, 3, 6, 9, 150};
    /** What the protocol calls a different pixel. */
    private static final double DIFFERENT = 1e-9;

    /** The pictures that most tests compare with, each rendered once. */
    private static final Map<ReferenceScene, RawPicture> QUICK = new ConcurrentHashMap<>();

    private static RawPicture quick(ReferenceScene reference) {
        return QUICK.computeIfAbsent(reference, r -> RawPicture.of(r.scene(), quick(r.scene())));
    }

    private static RenderSettings quick(Scene scene) {
        return RenderSettings.of(scene).withSize(48, 36).withThreads(1);
    }

    private static RenderSettings large(Scene scene) {
        return RenderSettings.of(scene).withSize(640, 480).withAntialias(1);
    }

    private static Scene shipped(String name) {
        return SceneReader.read(Path.of(System.getProperty("project.directory"), "scenes", name));
    }

    // N01

    @Test
    void aSceneTimesAPowerOfTwoGivesTheSameBits() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = quick(reference);
            for (int k : POWERS_OF_TWO) {
                Scene scaled = MovedScene.scaledByPowerOfTwo(scene, k);
                expected.assertSameBits(RawPicture.of(scaled, quick(scaled)), "2^" + k + " of " + reference);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice.json", "primitives.json", "glass.json", "torus.json"})
    void aShippedSceneTimesAPowerOfTwoOrElsewhereGivesTheSameBits(String name) {
        Scene scene = shipped(name);
        assertScaledAndMovedIsSame(scene, shippedSettings(scene, 40, 22), -899, 900);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice.json", "primitives.json", "glass.json", "torus.json"})
    void aLargerPictureOfAShippedSceneScaledOrMovedGivesTheSameBits(String name) {
        Scene scene = shipped(name);
        assertScaledAndMovedIsSame(scene, shippedSettings(scene, 64, 36), -900, -1, 900);
    }

    private static RenderSettings shippedSettings(Scene scene, int width, int height) {
        return quick(scene).withSize(width, height).withAntialias(2).with(new BuiltInMethod.RayTraceSettings(3));
    }

    private static void assertScaledAndMovedIsSame(Scene scene, RenderSettings settings, int... exponents) {
        RawPicture expected = RawPicture.of(scene, settings);
        for (int k : exponents) {
            expected.assertSameBits(RawPicture.of(MovedScene.scaledByPowerOfTwo(scene, k), settings), "2^" + k);
        }
        Scene far = MovedScene.translated(scene, new BigDecimal("1e15"));
        expected.assertSameBits(RawPicture.of(far, settings), "1e15 away");
    }

    @Test
    @Tag("full")
    void aLargePictureTimesAPowerOfTwoGivesTheSameBits() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = RawPicture.of(scene, large(scene));
            for (int k : MORE_POWERS_OF_TWO) {
                Scene scaled = MovedScene.scaledByPowerOfTwo(scene, k);
                expected.assertSameBits(RawPicture.of(scaled, large(scaled)), "2^" + k + " of " + reference);
            }
        }
    }

    /**
     * The scene's frame makes every scene equally large, which would hide a constant that knows the frame's unit. A speck
     * far behind the viewer makes the frame larger, so that everything that is seen becomes small in it. The limit is
     * that of squares of lengths, which doubles hold down to 2^-1074.
     */
    @ParameterizedTest
    @ValueSource(ints = {20, 34, 40, 400})
    void aSpeckFarBehindTheViewerChangesNoBit(int exponent) {
        assertSpeckChangesNoBit(exponent);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(ints = {5, 20, 28, 30, 32, 34, 36, 38, 40, 44, 48, 52, 56, 100, 200, 300, 400})
    void aSpeckAtMoreDistancesBehindTheViewerChangesNoBit(int exponent) {
        assertSpeckChangesNoBit(exponent);
    }

    private static void assertSpeckChangesNoBit(int exponent) {
        for (ReferenceScene reference :
                ReferenceScene.seenBy(ReferenceScene.GENERIC, ReferenceScene.ON_GRID, ReferenceScene.ORTHOGRAPHIC)) {
            Scene scene = reference.scene();
            assertSpeckChangesNoBit(quick(reference), scene, quick(scene), exponent, reference.toString());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice.json", "primitives.json", "glass.json", "torus.json"})
    void aSpeckFarBehindTheViewerOfAShippedSceneChangesNoBit(String name) {
        Scene scene = shipped(name);
        assertSpecksChangeNoBit(name, scene, shippedSettings(scene, 40, 22), 400);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice.json", "primitives.json", "glass.json", "torus.json"})
    void aSpeckBehindTheViewerOfALargerShippedSceneChangesNoBit(String name) {
        Scene scene = shipped(name);
        assertSpecksChangeNoBit(name, scene, shippedSettings(scene, 64, 36), 20, 400);
    }

    private static void assertSpecksChangeNoBit(String name, Scene scene, RenderSettings settings, int... exponents) {
        RawPicture expected = RawPicture.of(scene, settings);
        for (int exponent : exponents) {
            assertSpeckChangesNoBit(expected, scene, settings, exponent, name);
        }
    }

    private static void assertSpeckChangesNoBit(
            RawPicture expected, Scene scene, RenderSettings settings, int exponent, String what) {
        ExactPoint behind = new ExactPoint(
                BigDecimal.ZERO,
                BigDecimal.ONE,
                BigDecimal.valueOf(2).pow(exponent).negate());
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        objects.add(SceneObject.of(Sphere.of(behind, 0.01), TestScenes.matte(1, 0, 0)));
        RawPicture picture = RawPicture.of(withObjects(scene, objects), settings);
        expected.assertSameBits(picture, "2^" + exponent + " in { " + what + " }");
    }

    // N02

    @Test
    void aSceneTimesAPowerOfTenDiffersByRoundingsOnly() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            RawPicture expected = quick(reference);
            for (int k : POWERS_OF_TEN) {
                Scene scaled = reference.scaled(k);
                RawPicture picture = RawPicture.of(scaled, quick(scaled));
                assertEquals(0, expected.pixelsBeyond(picture, DIFFERENT), "10^" + k + " of " + reference);
            }
        }
    }

    @Test
    @Tag("full")
    void aLargePictureTimesAPowerOfTenDiffersByRoundingsOnly() throws IOException {
        StringBuilder figures = new StringBuilder("camera, exponent of ten, greatest difference, pixels beyond 1e-9\n");
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = RawPicture.of(scene, large(scene));
            // Round numbers may put samples onto edges, which may fall to either side: one pixel in two thousand.
            int allowed = reference.isOnGrid() ? expected.pixels() / 2000 : 0;
            for (int k : MORE_POWERS_OF_TEN) {
                Scene scaled = reference.scaled(k);
                RawPicture picture = RawPicture.of(scaled, large(scaled));
                int beyond = expected.pixelsBeyond(picture, DIFFERENT);
                double greatest = expected.greatestDifferenceUpTo(picture, DIFFERENT);
                figures.append(scene.camera().type() + ", " + k + ", " + greatest + ", " + beyond + "\n");
                assertTrue(beyond <= allowed, beyond + " pixels differ at 10^" + k + " of " + reference);
            }
        }
        Path folder = Path.of(System.getProperty("project.directory"), "target", "numerics");
        Files.writeString(Files.createDirectories(folder).resolve("decimal-scale.csv"), figures);
    }

    // N03

    @ParameterizedTest
    @ValueSource(strings = {"1e3", "1e15", "-1234567.000000000000000000000000000000891"})
    void aSceneMovedByADecimalInItsTextGivesTheSameBits(String t) {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene moved = reference.translated(new BigDecimal(t));
            quick(reference).assertSameBits(RawPicture.of(moved, quick(moved)), t + " of " + reference);
        }
    }

    @Test
    @Tag("full")
    void aLargePictureMovedByADecimalGivesTheSameBits() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = RawPicture.of(scene, large(scene));
            for (String t : List.of("1e3", "1e6", "1e9", "1e15")) {
                Scene moved = reference.translated(new BigDecimal(t));
                expected.assertSameBits(RawPicture.of(moved, large(moved)), t + " of " + reference);
            }
        }
    }

    // N04

    @ParameterizedTest
    @ValueSource(ints = {10, 30})
    void dyadicCoordinatesMovedInDoublesGiveTheSameBits(int k) {
        assertDyadicIsSame(k);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(ints = {10, 15, 20, 25, 30})
    void dyadicCoordinatesMovedFurtherAndFurtherGiveTheSameBits(int k) {
        assertDyadicIsSame(k);
    }

    private static void assertDyadicIsSame(int k) {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = MovedScene.rounded(reference.scene(), 20);
            Scene moved = MovedScene.translatedInDoubles(scene, Math.scalb(1.0, k));
            RawPicture.of(scene, quick(scene))
                    .assertSameBits(RawPicture.of(moved, quick(moved)), "2^" + k + " of " + reference);
        }
    }

    /**
     * At 2^40 the doubles of the coordinates are rounded to multiples of 2^-12, so it is another scene: edges move by up
     * to 2^-13 units, and 0.02 % of the pixels of a 640 × 480 picture by more than 0.01. Nothing else happens to it.
     */
    @Test
    void farBeyondTheDigitsOfDoublesOnlyTheInputIsRounded() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = MovedScene.rounded(reference.scene(), 20);
            Scene moved = MovedScene.translatedInDoubles(scene, 0x1p40);
            Scene rounded = MovedScene.roundedAsIfAt(scene, 0x1p40);
            RawPicture picture = RawPicture.of(moved, quick(moved));
            RawPicture.of(rounded, quick(rounded)).assertSameBits(picture, reference.toString());
            assertTrue(picture.pixelsBeyond(RawPicture.of(scene, quick(scene)), 0) > 0, "nothing was rounded");
        }
    }

    // N05

    @Test
    void theOrderOfObjectsChangesNoBit() {
        assertOrderChangesNoBit(1);
    }

    @Test
    @Tag("full")
    void moreOrdersOfObjectsChangeNoBit() {
        assertOrderChangesNoBit(10);
    }

    private static void assertOrderChangesNoBit(int orders) {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = quick(reference);
            for (int seed = 0; seed < orders; seed++) {
                List<SceneObject> objects = new ArrayList<>(scene.objects());
                Collections.shuffle(objects, new Random(seed));
                Scene shuffled = withObjects(scene, objects);
                expected.assertSameBits(RawPicture.of(shuffled, quick(shuffled)), "order " + seed);
            }
        }
    }

    static Scene withObjects(Scene s, List<SceneObject> objects) {
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                s.camera(),
                s.shading(),
                s.display(),
                s.textures(),
                s.materials(),
                s.lights(),
                objects,
                s.render(),
                s.animation());
    }

    @Test
    void aHierarchyChangesNoBit() {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RenderSettings settings = quick(scene);
            RawPicture.of(HierarchyChoice.compile(scene, settings, false), settings)
                    .assertSameBits(
                            RawPicture.of(HierarchyChoice.compile(scene, settings, true), settings),
                            reference.toString());
        }
    }

    @Test
    void threadsAndTilesChangeNoBit() {
        assertWaysChangeNoBit(new int[][] {{1, 64}, {7, 5}});
    }

    @Test
    @Tag("full")
    void moreThreadsAndTilesChangeNoBit() {
        assertWaysChangeNoBit(new int[][] {{1, 64}, {2, 1}, {2, 16}, {7, 5}});
    }

    private static void assertWaysChangeNoBit(int[][] ways) {
        for (ReferenceScene reference : ReferenceScene.all()) {
            Scene scene = reference.scene();
            RawPicture expected = quick(reference);
            for (int[] way : ways) {
                RenderSettings settings = quick(scene).withThreads(way[0]).withTileSize(way[1]);
                expected.assertSameBits(RawPicture.of(scene, settings), way[0] + " threads, tiles of " + way[1]);
            }
        }
    }
}

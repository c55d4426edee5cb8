package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.physical.InvarianceScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Numerics N01 to N06 with physical light: what must not matter changes no bit of the linear picture. */
class PhysicalInvarianceTest {
    private static final Scene RADIANCE = InvarianceScenes.byRadiance();
    private static final Scene POWER = InvarianceScenes.byPower();
    private static final Scene MANY = InvarianceScenes.ofManyLights();
    private static final Scene BLACK_LIGHT = InvarianceScenes.inBlackLight();
    private static final Map<Scene, float[]> EXPECTED = new IdentityHashMap<>();

    /** The pictures of all our methods, one behind the other. */
    private static float[] picture(Scene scene) {
        List<BuiltInMethod> methods = BuiltInMethod.rendering(Shading.Model.PHYSICAL);
        float[] all = new float[0];
        for (int i = 0; i < methods.size(); i++) {
            float[] one = picture(scene, settings(scene).withMethod(methods.get(i)));
            all = i == 0 ? Arrays.copyOf(one, methods.size() * one.length) : all;
            System.arraycopy(one, 0, all, i * one.length, one.length);
        }
        return all;
    }

    /** The pictures of a scene as it is, rendered once: what it is compared with changes. */
    private static float[] expected(Scene scene) {
        return EXPECTED.computeIfAbsent(scene, PhysicalInvarianceTest::picture).clone();
    }

    private static float[] picture(Scene scene, RenderSettings settings) {
        return Renderer.render(scene, settings).toArray();
    }

    private static RenderSettings settings(Scene scene) {
        return RenderSettings.of(scene).withAntialias(2).withThreads(1);
    }

    /** Each scene with each method that renders physical light. */
    static Stream<Arguments> pictures() {
        return Stream.of(RADIANCE, POWER, MANY, BLACK_LIGHT).flatMap(scene -> InvarianceScenes.methods().stream()
                .filter(method -> Method.supports(method, scene))
                .map(method -> Arguments.of(scene, settings(scene).withMethod(method))));
    }

    @Test
    void somethingIsSeen() {
        for (Scene scene : List.of(RADIANCE, POWER, MANY, BLACK_LIGHT)) {
            double sum = 0;
            float[] all = expected(scene);
            for (float v : all) {
                assertTrue(v >= 0 && v < Float.POSITIVE_INFINITY);
                sum += v;
            }
            assertTrue(sum / all.length > 0.05, "the pictures are dark");
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, -7, 900, -900})
    void aSceneTimesAPowerOfTwoGivesTheSameBits(int k) {
        assertArrayEquals(expected(RADIANCE), picture(MovedScene.scaledByPowerOfTwo(RADIANCE, k)));
    }

    @ParameterizedTest
    @ValueSource(ints = {3, -3, 400, -400})
    void powerAndIntensityGrowWithTheScene(int k) {
        assertArrayEquals(expected(POWER), picture(MovedScene.scaledByPowerOfTwo(POWER, k)));
        assertArrayEquals(expected(BLACK_LIGHT), picture(MovedScene.scaledByPowerOfTwo(BLACK_LIGHT, k)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, -5, 40, -40})
    void lightsTimesAPowerOfTwoGiveThePictureTimesIt(int k) {
        for (Scene scene : List.of(RADIANCE, POWER, MANY, BLACK_LIGHT)) {
            Scene brighter = brighter(scene, Math.scalb(1.0, k));
            float[] expected = expected(scene);
            for (int i = 0; i < expected.length; i++) {
                expected[i] = Math.scalb(expected[i], k);
            }
            assertArrayEquals(expected, picture(brighter));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e3", "1e15", "-1234567.000000000000000000000000000000891"})
    void aSceneMovedFarAwayGivesTheSameBits(String t) {
        for (Scene scene : List.of(RADIANCE, POWER)) {
            assertArrayEquals(expected(scene), picture(MovedScene.translated(scene, new BigDecimal(t))));
        }
    }

    @Test
    void theOrderOfObjectsAndLightsChangesNoBit() {
        assertOrderChangesNoBit(1);
    }

    @Test
    @Tag("full")
    void moreOrdersOfObjectsAndLightsChangeNoBit() {
        assertOrderChangesNoBit(10);
    }

    private static void assertOrderChangesNoBit(int orders) {
        for (Scene scene : List.of(RADIANCE, POWER, MANY, BLACK_LIGHT)) {
            float[] expected = expected(scene);
            for (int seed = 0; seed < orders; seed++) {
                List<SceneObject> objects = new ArrayList<>(scene.objects());
                Collections.shuffle(objects, new Random(seed));
                assertArrayEquals(expected, picture(with(scene, scene.lights(), objects)), "objects");
                List<Light> lights = new ArrayList<>(scene.lights());
                Collections.shuffle(lights, new Random(seed));
                assertArrayEquals(expected, picture(with(scene, lights, scene.objects())), "lights");
            }
        }
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void threadsAndTilesChangeNoBit(Scene scene, RenderSettings settings) {
        float[] expected = picture(scene, settings);
        for (int[] way : new int[][] {{1, 64}, {7, 5}}) {
            RenderSettings other = settings.withThreads(way[0]).withTileSize(way[1]);
            assertArrayEquals(expected, picture(scene, other), way[0] + " threads, tiles of " + way[1]);
        }
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void aCropShowsThePixelsOfTheWhole(Scene scene, RenderSettings settings) {
        Image whole = Renderer.render(scene, settings);
        Crop crop = new Crop(9, 5, 13, 11);
        Image part = Renderer.render(scene, settings.withCrop(crop));
        for (int i = 0; i < crop.width() * crop.height() * 3; i++) {
            int x = i / 3 % crop.width();
            int y = i / 3 / crop.width();
            assertEquals(whole.component(crop.x() + x, crop.y() + y, i % 3), part.component(x, y, i % 3));
        }
    }

    private static Scene brighter(Scene s, double factor) {
        List<Light> lights = s.lights().stream().map(l -> brighter(l, factor)).toList();
        List<SceneObject> objects = s.objects().stream()
                .map(o -> o.material() instanceof Material.Matte m
                        ? SceneObject.of(o.shape(), m.withRadiance(times(m.radiance(), factor)))
                        : o)
                .toList();
        Shading.Physical shading = (Shading.Physical) s.shading();
        Shading brighter = new Shading.Physical(
                shading.maxBounces(), times(((Shading.Background.Constant) shading.background()).radiance(), factor));
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                s.camera(),
                brighter,
                s.display(),
                s.textures(),
                s.materials(),
                lights,
                objects,
                s.render(),
                s.animation());
    }

    private static Light brighter(Light light, double factor) {
        Emission of = light.emission();
        Emission e = new Emission(of.quantity(), times(of.value(), factor), of.ultraviolet() * factor);
        if (light instanceof Light.Sphere s) {
            return new Light.Sphere(s.center(), s.radius(), s.color(), e);
        }
        if (light instanceof Light.Rectangle r) {
            return new Light.Rectangle(
                    r.lowerLeft(), r.upperLeft(), r.upperRight(), r.lowerRight(), r.color(), r.twoSided(), e);
        }
        return new Light.Point(((Light.Point) light).position(), light.color(), e);
    }

    private static Rgb times(Rgb v, double factor) {
        return new Rgb(v.r() * factor, v.g() * factor, v.b() * factor);
    }

    private static Scene with(Scene s, List<Light> lights, List<SceneObject> objects) {
        return new Scene(
                s.name(),
                s.width(),
                s.height(),
                s.camera(),
                s.shading(),
                s.display(),
                s.textures(),
                s.materials(),
                lights,
                objects,
                s.render(),
                s.animation());
    }
}

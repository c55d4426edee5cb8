package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.engine.DividedRender;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.Vec3;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Method {@code light} by any camera, against closed forms and paths from the eye. */
class LightMethodTest {
    private static final Map<String, Camera> CAMERAS = cameras();

    private static Map<String, Camera> cameras() {
        Map<String, Camera> all = new TreeMap<>();
        all.put("narrow", new Camera.Perspective(at(0.02, 1.01, -3.5), at(0.01, 0.9, 0), Vec3.Y, 12));
        all.put("wide", new Camera.Perspective(at(0.1, 0.9, -0.9), at(0.2, 0.8, 0), Vec3.Y, 100));
        all.put("orthographic", new Camera.Orthographic(at(0.3, 1.4, -3), at(0, 0.9, 0), Vec3.Y, 1.7));
        all.put("isometric", new Camera.Isometric(at(0, 1, 0), 2.2));
        all.put("window", window(0));
        all.put("oblique window", window(0.7));
        return all;
    }

    private static Camera window(double off) {
        return new Camera.Window(
                at(0.1 + off, 1.1 - off, -3),
                at(-0.9, 0.1, -1),
                at(-0.9, 1.9, -0.7),
                at(0.9, 1.9, -0.5),
                at(0.9, 0.1, -0.8),
                0);
    }

    static Stream<String> names() {
        return CAMERAS.keySet().stream();
    }

    private static RenderSettings light(Scene scene, int antialias) {
        return RenderSettings.of(scene).withMethod(BuiltInMethod.LIGHT).withAntialias(antialias);
    }

    /** White surfaces in white surroundings cannot be told from them, however much of the view they fill. */
    @ParameterizedTest
    @MethodSource("names")
    void aFurnaceIsEvenByEveryCameraAndAtEveryFieldOfView(String camera) {
        Scene scene = furnace().camera(CAMERAS.get(camera)).build();
        List<Image> pictures = Rendered.seeds(scene, light(scene, 4), 1, 12);
        Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, 16, 16, 1));
        assertTrue(Math.abs(s.mean() - 0.5) <= 6 * s.error() + 1e-6, s::toString);
        assertTrue(s.error() < 0.02, s::toString);
    }

    private static Scene.Builder furnace() {
        return Scene.builder()
                .size(16, 16)
                .shading(shading(0.5))
                .object(ball(-0.3, 0.6, 0, 0.6), matte(1, 1, 1))
                .object(ball(0.5, 1.2, -0.2, 0.4), matte(1, 1, 1).withRoughness(0.5))
                .object(new Box(at(0.1, 0, -0.6), at(0.7, 0.6, 0.1)), matte(1, 1, 1));
    }

    /** Welch's test of the quarters at 1 % for all of them and all cameras together. */
    @ParameterizedTest
    @MethodSource("names")
    void itMakesTheSamePictureAsPathsFromTheEyeByEveryCamera(String camera) {
        Scene scene = room().camera(CAMERAS.get(camera))
                .light(sphereLight(0.2, 1.5, -0.1, 0.3, 6))
                .light(panel(-0.4, 1.8, 0.2, 0.3, new Rgb(2, 4, 6), false))
                .object(ball(-0.35, 0.45, -0.1, 0.42), matte(0.8, 0.5, 0.3))
                .build();
        List<Image> light = Rendered.seeds(scene, light(scene, 4), 1, 12);
        List<Image> eye = Rendered.seeds(scene, 4, 1, 12);
        double level = Welch.sidak(0.01, 12 * CAMERAS.size());
        for (int k = 0; k < 12; k++) {
            int x = k / 3 % 2 * 8;
            int y = k / 6 * 8;
            double[] a = Rendered.means(light, x, y, x + 8, y + 8, k % 3);
            double[] b = Rendered.means(eye, x, y, x + 8, y + 8, k % 3);
            String what = "part " + k + ": " + Statistics.of(a) + " and " + Statistics.of(b);
            assertTrue(Welch.of(a, b).probability() >= level, what);
        }
    }

    @Test
    void emptySurroundingsAreSeenAsTheyAre() {
        Scene empty = Scene.builder()
                .size(4, 4)
                .camera(CAMERAS.get("narrow"))
                .shading(shading(0.25))
                .build();
        for (float v : Renderer.render(empty, light(empty, 1)).toArray()) {
            assertEquals(0.25f, v);
        }
    }

    @Test
    void withoutAnyLightThePictureIsBlack() {
        Scene dark = room().build();
        assertArrayEquals(
                new float[3 * 16 * 16], Renderer.render(dark, light(dark, 1)).toArray());
    }

    /** What stands behind the window's eye, or before its window, is not seen; it casts its shadow all the same. */
    @Test
    void nothingIsSeenBeforeAWindow() {
        Scene scene = Scene.builder()
                .size(8, 8)
                .camera(window(0))
                .shading(shading(0))
                .light(sphereLight(0, 1, -2, 0.2, 5))
                .object(ball(0.1, 1.1, -2.5, 0.1), matte(0.5, 0.5, 0.5))
                .build();
        assertArrayEquals(
                new float[3 * 8 * 8], Renderer.render(scene, light(scene, 2)).toArray());
    }

    @Test
    void whatItCannotSeeIsToldWhereASceneHasItAndNowhereElse() {
        Scene plain = room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6)).build();
        assertEquals(List.of(), blindSpots(plain, BuiltInMethod.LIGHT));
        Material glass = Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5);
        Material frosted =
                Glass.of(PhysicalScenes.linear(1, 1, 1), 1.5).withRoughness(0.5).withMultipleScattering(false);
        Material air = Glass.of(PhysicalScenes.linear(1, 1, 1), 1);
        for (Material seenThrough : List.of(frosted, air)) {
            Scene scene = room().object(ball(0, 1, 0, 0.3), seenThrough).build();
            assertEquals(List.of(), blindSpots(scene, BuiltInMethod.LIGHT));
        }
        for (Material shows : List.of(glass, Material.Mirror.of(PhysicalScenes.linear(1, 1, 1)))) {
            Scene scene = room().object(ball(0, 1, 0, 0.3), shows).build();
            assertEquals(1, blindSpots(scene, BuiltInMethod.LIGHT).size());
            assertEquals(List.of(), blindSpots(scene, BuiltInMethod.RAYTRACE));
            List<String> notes = new ArrayList<>();
            RenderProgress heard = new RenderProgress() {
                @Override
                public void progress(long done, long total, Supplier<Image> soFar) {}

                @Override
                public void note(String text) {
                    notes.add(text);
                }
            };
            RenderResult result = Renderer.render(scene, light(scene, 1), heard, () -> false);
            assertTrue(notes.stream().anyMatch(n -> n.contains("cannot see surfaces in mirrors")), notes::toString);
            assertTrue(result.report().features().stream().anyMatch(f -> f.contains("cannot see")));
        }
    }

    @Test
    void whatNoMethodSeesOfPointLightsIsTold() {
        Material mirror = Material.Mirror.of(PhysicalScenes.linear(1, 1, 1));
        Light point = new Light.Point(at(0, 1.5, -0.5), Rgb.WHITE, Emission.intensity(Rgb.WHITE));
        Scene plain = room().light(point)
                .object(ball(0, 1, 0, 0.3), matte(0.5, 0.5, 0.5))
                .build();
        Scene mirrored = room().light(point).object(ball(0, 1, 0, 0.3), mirror).build();
        Scene withoutPoint = room().object(ball(0, 1, 0, 0.3), mirror).build();
        for (Scene scene : List.of(plain, withoutPoint, mirrored)) {
            boolean isTold = Renderer.inspect(scene, RenderSettings.of(scene)).hints().stream()
                    .anyMatch(hint -> hint.contains("light of points"));
            assertEquals(scene == mirrored, isTold);
        }
    }

    @Test
    void whatHardlyAnyPathFindsInMediaIsTold() {
        Medium dense = new Medium.Coefficients(Rgb.gray(5), Rgb.gray(0.1), 0);
        Scene small = room().light(sphereLight(0, 1.8, 0, 0.01, 900))
                .object(ball(0, 0.5, 0, 0.3), new Material.Scattering(dense, 1.4, 0, 0))
                .build();
        Scene large = room().light(sphereLight(0, 1.8, 0, 0.15, 4))
                .object(ball(0, 0.5, 0, 0.3), new Material.Scattering(dense, 1.4, 0, 0))
                .build();
        Scene withoutInterface = room().light(sphereLight(0, 1.8, 0, 0.01, 900))
                .object(ball(0, 0.5, 0, 0.3), Material.Scattering.of(dense))
                .build();
        for (Scene scene : List.of(small, large, withoutInterface)) {
            boolean isTold = Renderer.inspect(scene, RenderSettings.of(scene)).hints().stream()
                    .anyMatch(hint -> hint.contains("small lamps in media whose interface refracts"));
            assertEquals(scene == small, isTold);
        }
    }

    private static List<String> blindSpots(Scene scene, BuiltInMethod method) {
        return Renderer.inspect(scene, RenderSettings.of(scene).withMethod(method)).hints().stream()
                .filter(hint -> hint.contains("cannot see"))
                .toList();
    }

    @Test
    void aCropSaysThatItSavesLittle() {
        Scene scene = room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6)).build();
        RenderSettings settings = light(scene, 1).withCrop(new RenderSettings.Crop(2, 2, 4, 4));
        List<String> notes = DividedRender.prepare(scene, settings, () -> false).notes();
        assertTrue(
                notes.size() == 1 && notes.get(0).contains("of the whole picture and saves little time"),
                notes::toString);
    }

    /** The upper end of the interval is as asked, and so is the true error. */
    @Test
    void anErrorThatIsAskedForIsKept() {
        Scene scene = room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6)).build();
        RenderSettings exact = RenderSettings.of(scene).withAntialias(40);
        float[] truth = Renderer.render(scene, exact).toArray();
        for (int seed = 1; seed <= 3; seed++) {
            RenderSettings settings =
                    light(scene, 1).withSeed(seed).withBudget(RenderSettings.Budget.NONE.withError(0.03));
            RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
            assertTrue(result.report().sampling().errorInFile() <= 0.03);
            float[] picture = result.image().toArray();
            double sum = 0;
            for (int i = 0; i < truth.length; i++) {
                double d = shown(picture[i]) - shown(truth[i]);
                sum += d * d;
            }
            assertTrue(Math.sqrt(sum / truth.length) <= 0.03);
        }
    }

    private static double shown(double light) {
        return TransferCurve.encode(Math.min(light, 1));
    }

    @Test
    void classicShadingIsRefused() {
        Scene scene = TestScenes.whiteFireAndIce().build();
        SceneException e = assertThrows(SceneException.class, () -> Renderer.render(scene, light(scene, 1)));
        assertTrue(e.getMessage().contains("cannot render classic shading, only physical"), e.getMessage());
    }
}

package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Disks at infinity: closed forms, and the same picture by every method. */
class DistantLightsTest {
    private static final double REFLECTANCE = 0.6;
    private static final Vec3 SLANTED = new Vec3(1, -2, 0.5);
    private static final Map<String, Scene> SCENES = scenes();
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(12, 8);

    record Case(BuiltInMethod method, String name) {}

    private static RenderSettings settings(Scene scene, BuiltInMethod method, int antialias) {
        return RenderSettings.of(scene).withMethod(method).withThreads(1).withAntialias(antialias);
    }

    private static Light distant(Vec3 direction, double angle, double r, double g, double b) {
        return new Light.Distant(direction, angle, Rgb.WHITE, Emission.irradiance(new Rgb(r, g, b)));
    }

    /** The cosine at a horizontal floor. */
    private static double cosine(Vec3 direction) {
        return -direction.normalized().y();
    }

    private static Scene.Builder floor(double background) {
        return Scene.builder()
                .size(4, 4)
                .shading(PhysicalScenes.atMost(1, background))
                .camera(new Camera.Perspective(at(0, 3, 0), at(0, 0, 0), Vec3.Z, 20))
                .object(
                        TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1),
                        matte(REFLECTANCE, REFLECTANCE, REFLECTANCE));
    }

    private static void assertShown(Scene scene, BuiltInMethod method, double... radiance) {
        new ClosedForms.Known(method.word(), scene, radiance).assertShown(settings(scene, method, 4));
    }

    /** L = ρ E cos α / π, however wide the disk is. */
    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aSlantedFloorHasTheIrradianceTimesTheCosine(BuiltInMethod method) {
        for (double angle : new double[] {Light.Distant.LEAST_ANGLE, 0.53, Light.Distant.GREATEST_ANGLE}) {
            Scene scene = floor(0).light(distant(SLANTED, angle, 3, 1, 0)).build();
            double red = REFLECTANCE / Math.PI * 3 * cosine(SLANTED);
            assertShown(scene, method, red, red / 3, 0);
        }
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void theLightOfAConstantBackgroundIsAdded(BuiltInMethod method) {
        Scene scene = floor(0.5).light(distant(SLANTED, 1, 3, 1, 0)).build();
        double red = REFLECTANCE / Math.PI * 3 * cosine(SLANTED);
        double even = REFLECTANCE * 0.5;
        assertShown(scene, method, red + even, red / 3 + even, even);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void theIrradiancesOfManyLightsAddUp(BuiltInMethod method) {
        Scene.Builder scene = floor(0.1);
        double sum = REFLECTANCE * 0.1;
        for (int k = 0; k < 7; k++) {
            Vec3 direction = new Vec3(Math.sin(k), -0.3 - k % 3, Math.cos(k));
            scene.light(distant(direction, 0.1 + k, k, k, k));
            sum += REFLECTANCE / Math.PI * k * cosine(direction);
        }
        assertShown(scene.build(), method, sum, sum, sum);
    }

    @ParameterizedTest
    @EnumSource(BuiltInMethod.class)
    void aSkyKeepsItsSunBesideADistantLight(BuiltInMethod method) {
        Shading.Background.Sky sky = new Shading.Background.Sky(40, 20, 3, Rgb.gray(0.2), Rgb.WHITE, true);
        Shading.Physical shading = new Shading.Physical(OptionalInt.of(1), sky, Optional.empty());
        Statistics alone = mean(floor(0).shading(shading).build(), BuiltInMethod.RAYTRACE);
        Statistics both = mean(
                floor(0).shading(shading).light(distant(SLANTED, 1, 2, 2, 2)).build(), method);
        double added = REFLECTANCE / Math.PI * 2 * cosine(SLANTED);
        assertEquals(alone.mean() + added, both.mean(), 6 * Math.hypot(alone.error(), both.error()), method.word());
    }

    private static Statistics mean(Scene scene, BuiltInMethod method) {
        return Statistics.of(Rendered.means(Rendered.seeds(scene, settings(scene, method, 8), 1, 12), 0, 0, 4, 4, 0));
    }

    /** The radiance of the disk is E / (π sin² of half its angle); paths from lights do not show it. */
    @ParameterizedTest
    @EnumSource(value = BuiltInMethod.class, mode = EnumSource.Mode.EXCLUDE, names = "LIGHT")
    void theDiskIsSeenWithItsRadiance(BuiltInMethod method) {
        double sine = Math.sin(Math.toRadians(5));
        Scene scene = Scene.builder()
                .size(4, 4)
                .shading(PhysicalScenes.atMost(1, 0.25))
                .camera(new Camera.Perspective(at(0, 0, 0), at(0, 1, 1), Vec3.Y, 2))
                .object(ball(0, -9, 0, 1), PhysicalScenes.WHITE)
                .light(distant(new Vec3(0, -1, -1), 10, 0.3, 0.2, 0.1))
                .build();
        double perIrradiance = 1 / (Math.PI * sine * sine);
        assertShown(scene, method, 0.25 + 0.3 * perIrradiance, 0.25 + 0.2 * perIrradiance, 0.25 + 0.1 * perIrradiance);
    }

    @Test
    void theOrderOfLightsHasNoInfluence() {
        Light one = distant(SLANTED, 1, 3, 1, 0);
        Light other = distant(new Vec3(-1, -1, 0), 2, 0, 1, 3);
        Scene scene = floor(0.1).light(one).light(other).build();
        Scene turned = floor(0.1).light(other).light(one).build();
        assertArrayEquals(
                Renderer.render(scene, settings(scene, BuiltInMethod.RAYTRACE, 2))
                        .toArray(),
                Renderer.render(turned, settings(turned, BuiltInMethod.RAYTRACE, 2))
                        .toArray());
    }

    @Test
    void whatIsNoDistantLightIsRefusedByItsKey() {
        assertKey("direction", () -> new Light.Distant(Vec3.ZERO, Rgb.WHITE));
        assertKey("angle", () -> distant(SLANTED, 0, 1, 1, 1));
        assertKey("angle", () -> distant(SLANTED, 21, 1, 1, 1));
        assertKey("irradiance", () -> distant(SLANTED, 0.01, 1e99, 1, 1));
        assertKey("power", () -> new Light.Distant(SLANTED, 1, Rgb.WHITE, Emission.power(Rgb.WHITE)));
        assertKey(
                "ultraviolet",
                () -> new Light.Distant(SLANTED, 1, Rgb.WHITE, Emission.IRRADIANCE_1.withUltraviolet(1)));
        assertKey("irradiance", () -> new Light.Point(at(0, 0, 0), Rgb.WHITE, Emission.IRRADIANCE_1));
        assertKey("irradiance", () -> new Light.Sphere(at(0, 0, 0), 1, Rgb.WHITE, Emission.IRRADIANCE_1));
    }

    private static void assertKey(String key, Runnable made) {
        InvalidValueException e = assertThrows(InvalidValueException.class, made::run);
        assertTrue(e.key().equals(key), e.getMessage());
    }

    /** A room that is open to the viewer and has a window in its roof. */
    private static Scene.Builder windowed() {
        return PhysicalScenes.view(16, 16)
                .shading(PhysicalScenes.atMost(6, 0))
                .object(new Box(at(-1, -0.1, -1), at(1, 0, 1)), PhysicalScenes.WHITE)
                .object(new Box(at(-1, 0, 1), at(1, 2, 1.1)), PhysicalScenes.WHITE)
                .object(new Box(at(-1.1, 0, -1), at(-1, 2, 1)), PhysicalScenes.RED)
                .object(new Box(at(1, 0, -1), at(1.1, 2, 1)), PhysicalScenes.GREEN)
                .object(new Box(at(-1, 2, -1), at(-0.2, 2.1, 1)), PhysicalScenes.WHITE)
                .object(new Box(at(0.4, 2, -1), at(1, 2.1, 1)), PhysicalScenes.WHITE);
    }

    private static Map<String, Scene> scenes() {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        Vec3 down = new Vec3(-0.2, -1, 0.1);
        scenes.put(
                "window",
                windowed()
                        .object(ball(-0.4, 0.4, 0.1, 0.4), PhysicalScenes.WHITE)
                        .light(distant(down, 0.53, 4, 3, 2))
                        .light(distant(new Vec3(0.1, -1, 0.2), 3, 0, 0.5, 1))
                        .build());
        scenes.put(
                "mirror and glass",
                windowed()
                        .shading(PhysicalScenes.atMost(6, 0.1))
                        .object(ball(-0.4, 0.5, 0.1, 0.35), Material.Mirror.of(linear(0.9, 0.9, 0.9)))
                        .object(ball(0.15, 0.6, -0.2, 0.35), Glass.of(linear(1, 1, 1), 1.5))
                        .light(distant(down, 20, 4, 3, 2))
                        .build());
        // The ball is above the view.
        scenes.put(
                "caustic",
                Scene.builder()
                        .size(16, 16)
                        .shading(PhysicalScenes.atMost(4, 0))
                        .camera(new Camera.Perspective(at(0, 1, -1.5), at(0.1, 0, 0), Vec3.Y, 25))
                        .object(new Box(at(-1, -0.1, -1), at(1, 0, 1)), PhysicalScenes.WHITE)
                        .object(ball(0.2, 1.1, -0.1, 0.3), Glass.of(linear(1, 1, 1), 1.5))
                        .light(distant(down, 8, 4, 3, 2))
                        .light(distant(new Vec3(0.3, -1, 0), 14, 1, 2, 3))
                        .build());
        Medium fog = Medium.Coefficients.of(new Rgb(0.8, 0.6, 0.4), Rgb.gray(0.1));
        scenes.put(
                "fog",
                windowed()
                        .object(new Box(at(-0.9, 0.1, -0.9), at(0.9, 1.9, 0.9)), Material.Scattering.of(fog))
                        .light(distant(down, 0.53, 4, 3, 2))
                        .build());
        return scenes;
    }

    static List<Case> partners() {
        List<Case> cases = new ArrayList<>();
        for (String name : SCENES.keySet()) {
            for (BuiltInMethod method : DirectedLights.METHODS) {
                // Light paths do not find what mirrors and glass show.
                boolean isFound = method != BuiltInMethod.LIGHT || !name.contains("mirror");
                if (method != BuiltInMethod.RAYTRACE && isFound) {
                    cases.add(new Case(method, name));
                }
            }
        }
        return cases;
    }

    @ParameterizedTest
    @MethodSource("partners")
    void allMethodsMakeThePictureOfSinglePaths(Case c) {
        Scene scene = SCENES.get(c.name);
        List<Image> traced = REFERENCES.of(c.name, scene);
        List<Image> others = Rendered.seeds(scene, settings(scene, c.method, 8), 1, 12);
        Rendered.assertPartsAgree(traced, others, 12 * partners().size());
    }
}

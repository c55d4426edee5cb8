package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.panel;
import static enlightenment.physical.PhysicalScenes.room;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
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
import enlightenment.math.Vec3;
import enlightenment.render.Renderer;
import enlightenment.render.TestScenes;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Light that media scatter, from the lights and from the eye: one picture. */
class LightInMediaTest {
    private static final int SEEDS = 12;
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(SEEDS, 4);
    private static final int PARTS = 12;
    private static final Map<String, Scene.Builder> SCENES = scenes();

    private static Medium medium(double r, double g, double b, double absorbed, double anisotropy) {
        return new Medium.Coefficients(new Rgb(r, g, b), Rgb.gray(absorbed), anisotropy);
    }

    private static Scene.Builder lit() {
        return room().light(sphereLight(0.2, 1.5, -0.1, 0.3, 6));
    }

    private static Shading.Physical fog(Medium medium, OptionalInt bounces) {
        return new Shading.Physical(bounces, Shading.Background.Constant.BLACK, Optional.of(medium));
    }

    private static Map<String, Scene.Builder> scenes() {
        Map<String, Scene.Builder> all = new LinkedHashMap<>();
        all.put("wax", lit().object(ball(-0.1, 0.6, -0.3, 0.5), Material.Scattering.of(medium(6, 5, 3, 0.3, 0.3))));
        all.put(
                "grey cloud that throws light back",
                lit().object(ball(-0.1, 0.6, -0.3, 0.5), Material.Scattering.of(medium(4, 4, 4, 0, -0.5))));
        all.put(
                "lamp in a cloud",
                room().light(sphereLight(0.1, 0.9, -0.2, 0.15, 12))
                        .object(ball(0.1, 0.9, -0.2, 0.6), Material.Scattering.of(medium(1, 3, 5, 0.1, 0.6))));
        all.put(
                "fog with a panel",
                room().light(panel(-0.4, 1.8, 0.2, 0.3, new Rgb(5, 10, 15), false))
                        .object(ball(-0.35, 0.45, -0.1, 0.42), matte(0.8, 0.5, 0.3))
                        .shading(fog(medium(0.3, 0.2, 0.1, 0.05, 0.7), OptionalInt.empty())));
        all.put(
                "fog by a point, twice scattered at most",
                room().light(new Light.Point(at(0.1, 1.5, -0.4), Rgb.WHITE, Emission.intensity(new Rgb(5, 4, 2))))
                        .shading(fog(medium(0.5, 0.5, 0.5, 0, 0), OptionalInt.of(2))));
        all.put(
                "cloud within another, under a pane's worth of air",
                lit().object(
                                new Box(at(-0.8, 0.1, -0.7), at(0.8, 1.3, 0.4)),
                                Material.Scattering.of(medium(1, 1, 2, 0.2, 0)))
                        .object(ball(0.1, 0.7, -0.2, 0.3), new Material.Scattering(medium(9, 6, 3, 0.5, 0.2), 1, 0, 1))
                        .object(ball(-0.4, 0.7, -0.4, 0.2), new Glass(PhysicalScenes.linear(1, 1, 1), 1, 1, 2, true)));
        all.put(
                "cloud that takes light from a room that glows",
                Scene.builder()
                        .size(16, 16)
                        .camera(new Camera.Perspective(at(0.3, 0.2, -0.1), at(0.1, 0.2, 1), Vec3.Y, 30))
                        .shading(Shading.Physical.DEFAULT)
                        .object(ball(0, 0, 0, 1), matte(0.6, 0.5, 0.3).withRadiance(new Rgb(0.1, 0.2, 0.3)))
                        .object(ball(0.1, 0.2, 0.5, 0.3), Material.Scattering.of(medium(1, 1, 1, 3, 0.3))));
        return all;
    }

    static Stream<String> names() {
        return SCENES.keySet().stream();
    }

    private static RenderSettings by(BuiltInMethod method, Scene scene) {
        return RenderSettings.of(scene).withMethod(method).withAntialias(4);
    }

    /** All surfaces are on the lamp's side of the wall, but the fog is not. */
    @Test
    void aWallHidesALampFromTheFogBehindIt() {
        double far = 1000;
        Scene scene = PhysicalScenes.view(8, 8)
                .shading(fog(medium(0.3, 0.3, 0.3, 0.05, 0), OptionalInt.of(1)))
                .light(sphereLight(0, 1, -6, 0.5, 6))
                .object(
                        TestScenes.rectangle(-far, -far, -4.5, -far, far, -4.5, far, far, -4.5, far, -far, -4.5),
                        PhysicalScenes.matte(0, 0, 0))
                .build();
        for (BuiltInMethod method :
                List.of(BuiltInMethod.RAYTRACE, BuiltInMethod.CLUSTER, BuiltInMethod.BIDIRECTIONAL)) {
            Image image = Renderer.render(
                    scene, RenderSettings.of(scene).withMethod(method).withAntialias(4));
            for (int k = 0; k < 64; k++) {
                assertEquals(0, image.component(k % 8, k / 8, 0), method + ", pixel " + k);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("names")
    void pathsFromTheLightsMakeThePictureOfPathsFromTheEye(String name) {
        bothMakeTheSamePicture(BuiltInMethod.LIGHT, name);
    }

    @ParameterizedTest
    @MethodSource("names")
    void pathsFromBothEndsMakeItToo(String name) {
        bothMakeTheSamePicture(BuiltInMethod.BIDIRECTIONAL, name);
    }

    /** Welch's test of the quarters at 1 % for all of them and all scenes and methods together. */
    private static void bothMakeTheSamePicture(BuiltInMethod method, String name) {
        Scene scene = SCENES.get(name).build();
        RenderSettings settings = by(method, scene);
        List<Image> light = Rendered.seeds(scene, settings, 1, SEEDS);
        List<Image> eye = REFERENCES.of(name, scene);
        double level = Welch.sidak(0.01, 2 * PARTS * SCENES.size());
        for (int k = 0; k < PARTS; k++) {
            int x = k / 3 % 2 * 8;
            int y = k / 6 * 8;
            double[] a = Rendered.means(light, x, y, x + 8, y + 8, k % 3);
            double[] b = Rendered.means(eye, x, y, x + 8, y + 8, k % 3);
            String what = "part " + k + ": " + Statistics.of(a) + " and " + Statistics.of(b);
            assertTrue(Welch.of(a, b).probability() >= level, what);
            assertTrue(Statistics.of(a).error() < 0.2 * Statistics.of(a).mean(), what);
        }
    }

    /** A medium that absorbs nothing is not seen where as much light comes from everywhere: paths bring what they take away. */
    @ParameterizedTest
    @CsvSource({"LIGHT, -0.7", "LIGHT, 0", "LIGHT, 0.6", "BIDIRECTIONAL, 0", "BIDIRECTIONAL, 0.6"})
    void aCloudIsNotSeenInAFurnace(BuiltInMethod method, double anisotropy) {
        Scene empty = Scene.builder()
                .size(16, 16)
                .camera(room().build().camera())
                .shading(new Shading.Physical(OptionalInt.empty(), Rgb.gray(0.5)))
                .object(ball(0, 0.9, -2, 0.5), Material.Scattering.of(medium(8, 4, 2, 0, anisotropy)))
                .build();
        List<Image> pictures = Rendered.seeds(empty, by(method, empty), 1, SEEDS);
        for (int band = 0; band < 3; band++) {
            Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, 16, 16, band));
            assertTrue(Math.abs(s.mean() - 0.5) <= 5 * s.error() + 1e-6, s::toString);
            assertTrue(s.error() < 0.03, s::toString);
        }
    }

    /** Nothing of the surroundings comes through a fog that has no end, however thin it is and whoever looks for it. */
    @ParameterizedTest
    @MethodSource("methods")
    void theSurroundingsAreNotSeenThroughFog(BuiltInMethod method) {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(room().build().camera())
                .shading(new Shading.Physical(
                        OptionalInt.empty(),
                        new Shading.Background.Constant(Rgb.gray(0.5)),
                        Optional.of(medium(0, 0, 0, 1e-9, 0))))
                .object(ball(0.1, 0.9, -0.2, 0.6), matte(0.5, 0.5, 0.5))
                .build();
        assertArrayEquals(
                new float[3 * 4 * 4], Renderer.render(scene, by(method, scene)).toArray());
    }

    static Stream<BuiltInMethod> methods() {
        return Stream.of(BuiltInMethod.RAYTRACE, BuiltInMethod.LIGHT, BuiltInMethod.BIDIRECTIONAL);
    }
}

package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** What lies exactly where camera rays start is before the eye, by every method: rays that start on a surface meet it there. */
class SurfaceAtEyeTest {
    private static final String PERSPECTIVE =
            "\"type\": \"perspective\", \"eye\": [0.1, 0.5, -3], \"lookAt\": [0, -0.8, 0], \"fieldOfView\": 30";

    /** The floor, through a window in the plane z = −3. */
    private static final String WINDOW =
            """
            "type": "window", "eye": [0.1, 0.7, -4.3], "lowerLeft": [-0.5, -0.3, -3], "upperLeft": [-0.5, 0.2, -3],
            "upperRight": [0.5, 0.2, -3], "lowerRight": [0.5, -0.3, -3]""";

    /** Rays that go along z from the plane z = −3, to a wall. */
    private static final String ORTHOGRAPHIC =
            "\"type\": \"orthographic\", \"eye\": [0.1, 0.3, -3], \"lookAt\": [0.1, 0.3, 0], \"height\": 1";

    private static final String PANE =
            """
            { "type": "glass", "color": { "linear": [0.9, 0.8, 0.7] }, "indexOfRefraction": 1 }""";

    private static final String MATTE = """
            { "type": "matte", "color": "#ffffff" }""";

    /** A floor and a wall below a lamp, and what is in the plane z = −3; far above there is a pane. */
    private static Scene scene(String camera, String material) {
        return scene(camera, material, -1);
    }

    private static Scene scene(String camera, String material, double lamp) {
        String plane = material.isEmpty()
                ? ""
                : """
                , { "type": "rectangle", "corners": [[-9, -9, -3], [-9, 9, -3], [9, 9, -3], [9, -9, -3]],
                    "material": %s }"""
                        .formatted(material);
        return SceneReader.readString(
                """
                { "image": { "width": 6, "height": 4 }, "camera": { %s }, "shading": { "model": "physical" },
                  "lights": [ { "type": "sphere", "center": [0, 1.6, %s], "radius": 0.3, "radiance": 20,
                                "color": "#ffffff" } ],
                  "objects": [
                    { "type": "rectangle", "corners": [[-3, -1, -3], [-3, -1, 3], [3, -1, 3], [3, -1, -3]],
                      "material": { "type": "matte", "color": { "linear": [0.8, 0.6, 0.4] } } },
                    { "type": "rectangle", "corners": [[-3, -1, 3], [-3, 3, 3], [3, 3, 3], [3, -1, 3]],
                      "material": { "type": "matte", "color": { "linear": [0.8, 0.6, 0.4] } } },
                    { "type": "rectangle", "corners": [[-3, 8, -2], [-3, 8, 3], [3, 8, 3], [3, 8, -2]],
                      "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1 } } %s ] }"""
                        .formatted(camera, lamp, plane),
                Path.of("."),
                "");
    }

    private static String camera(String name) {
        return switch (name) {
            case "perspective" -> PERSPECTIVE;
            case "window" -> WINDOW;
            default -> ORTHOGRAPHIC;
        };
    }

    /** Each camera by a method with paths from the eye, from the lights, and from both. */
    static Stream<Arguments> views() {
        return Stream.of("perspective", "window", "orthographic")
                .flatMap(camera -> Stream.of(BuiltInMethod.RAYTRACE, BuiltInMethod.LIGHT, BuiltInMethod.BIDIRECTIONAL)
                        .map(method -> Arguments.of(camera, method)));
    }

    private static double mean(Scene scene, BuiltInMethod method, int band) {
        return mean(scene, method, band, 256);
    }

    private static double mean(Scene scene, BuiltInMethod method, int band, double samples) {
        RenderSettings settings = RenderSettings.of(scene)
                .withMethod(method)
                .withThreads(1)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        Image image = Renderer.render(scene, settings);
        float[] rgb = image.toArray();
        double sum = 0;
        for (int i = band; i < rgb.length; i += 3) {
            sum += rgb[i];
        }
        return 3 * sum / rgb.length;
    }

    @ParameterizedTest
    @MethodSource("views")
    void aPaneThereTintsThePicture(String camera, BuiltInMethod method) {
        for (int band = 0; band < 3; band++) {
            double without = mean(scene(camera(camera), ""), method, band);
            double with = mean(scene(camera(camera), PANE), method, band);
            assertTrue(without > 0.01, "there is light to be tinted: " + without);
            double tint = 0.9 - 0.1 * band;
            // The same random numbers with and without.
            assertEquals(tint, with / without, 0.004 * tint, "band " + band);
        }
    }

    @ParameterizedTest
    @MethodSource("views")
    void anOpaqueSurfaceThereHidesAllThatIsBehind(String camera, BuiltInMethod method) {
        // The lamp is behind it.
        assertEquals(0, mean(scene(camera(camera), MATTE), method, 0));
    }

    @ParameterizedTest
    @CsvSource({"window, LIGHT", "window, BIDIRECTIONAL", "orthographic, LIGHT", "orthographic, BIDIRECTIONAL"})
    void anOpaqueSurfaceInThePlaneOfThePictureIsSeenThere(String camera, BuiltInMethod method) {
        Scene poster = scene(camera(camera), MATTE, -4.2);
        double expected = mean(poster, BuiltInMethod.RAYTRACE, 0);
        assertTrue(expected > 0.1, "the lamp is before it: " + expected);
        // About 2 % of half a million paths come to what is seen of it: five standard errors.
        assertEquals(expected, mean(poster, method, 0, 20_000), 0.05 * expected);
    }
}

package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.plan.Integrators;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Light that few paths find follows from the scene, and is said whatever the samples of a picture show. */
class UndersampledLightTest {
    @TempDir
    Path folder;

    private static String metal(double roughness) {
        return "{ \"type\": \"glossy\", \"color\": \"#e0c0a0\", \"roughness\": " + roughness + " }";
    }

    private static String ball(double x, String material) {
        return "{ \"type\": \"sphere\", \"center\": [" + x + ", 0, 0], \"radius\": 0.5, \"material\": " + material
                + " }";
    }

    private static String torus(String material) {
        return "{ \"type\": \"torus\", \"center\": [0, 0, 0], \"axis\": [0, 1, 0], \"majorRadius\": 1,"
                + " \"minorRadius\": 0.3, \"material\": " + material + " }";
    }

    private static String wax(double index, double roughness) {
        return "{ \"type\": \"scattering\", \"scatteringCoefficient\": 4, \"absorptionCoefficient\": 0.1,"
                + " \"indexOfRefraction\": " + index + ", \"roughness\": " + roughness + " }";
    }

    private String reason(BuiltInMethod method, double lamp, String... objects) throws IOException {
        String file =
                """
                {
                  "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 1, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": %s, "color": "#ffffff", "power": 90 } ],
                  "objects": [ %s ]
                }
                """
                        .formatted(lamp, String.join(",", objects));
        Path path = Files.createTempFile(folder, "scene", ".json");
        Files.writeString(path, file);
        return reason(method, SceneReader.read(path));
    }

    private static String reason(BuiltInMethod method, Scene scene) {
        RenderSettings settings = RenderSettings.of(scene).withMethod(method);
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        return String.join("; ", Integrators.undersampled(method, compiled));
    }

    @ParameterizedTest
    @CsvSource({"RAYTRACE", "CLUSTER", "BIDIRECTIONAL", "METROPOLIS", "LIGHT"})
    void aSmallLampByTwoNarrowLobesOrAMirrorAndANarrowLobeIsUndersampled(BuiltInMethod method) throws IOException {
        String mirror = "{ \"type\": \"mirror\", \"color\": \"#f0f0f0\" }";
        String glass = "{ \"type\": \"glass\", \"color\": \"#ffffff\", \"indexOfRefraction\": 1.5, \"roughness\": %s }";
        List<String[]> chains = List.of(
                new String[] {ball(-1, metal(0.15)), ball(1, metal(0.2))},
                new String[] {ball(-1, metal(0.15)), ball(1, mirror)},
                new String[] {ball(-1, metal(0.15)), ball(1, glass.formatted(0))},
                new String[] {torus(metal(0.15))},
                new String[] {ball(0, glass.formatted(0.15))});
        for (String[] objects : chains) {
            assertTrue(reason(method, 0.05, objects).contains("two narrow lobes in a row"), String.join(" ", objects));
        }
    }

    /** One narrow lobe is convex and alone, lobes are wide, or the lamp is larger than the lobes: samples find it. */
    @Test
    void whatSamplesFindIsNot() throws IOException {
        String matte = "{ \"type\": \"matte\", \"color\": \"#808080\" }";
        String mirror = "{ \"type\": \"mirror\", \"color\": \"#f0f0f0\" }";
        assertEquals("", reason(BuiltInMethod.RAYTRACE, 0.05, ball(-1, metal(0.15)), ball(1, matte)));
        for (String first : List.of(metal(0.3), mirror)) {
            String said = reason(BuiltInMethod.RAYTRACE, 0.05, ball(-1, first), ball(1, mirror));
            assertEquals("few paths find small lamps and caustics that are seen in mirrors or through glass", said);
        }
        assertEquals("", reason(BuiltInMethod.RAYTRACE, 1.2, ball(-1, metal(0.15)), torus(metal(0.15))));
    }

    @Test
    void lightPathsSeldomLeaveMediaByRoughInterfaces() throws IOException {
        for (BuiltInMethod method : BuiltInMethod.values()) {
            assertEquals(
                    method == BuiltInMethod.LIGHT,
                    reason(method, 0.3, ball(0, wax(1.4, 0.4))).contains("rough interface"));
        }
        assertEquals("", reason(BuiltInMethod.LIGHT, 0.3, ball(0, wax(1, 0))));
        assertFalse(reason(BuiltInMethod.LIGHT, 0.3, ball(0, wax(1.4, 0))).contains("interface"));
    }

    /** A lamp that is large as seen from a mirror ball, which is a few pixels large itself: its image is less than one. */
    @ParameterizedTest
    @CsvSource({"24, true", "960, false"})
    void aLampIsSmallInAMirrorThatIsSmallItself(int width, boolean isSmall) {
        String scene =
                """
                { "image": { "width": WIDTH, "height": WIDTH }, "shading": { "model": "physical" },
                  "camera": { "type": "perspective", "eye": [0, 0, -6], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "lights": [ { "type": "sphere", "center": [2, 2, -9], "radius": 2.4, "color": "#ffffff", "radiance": [3, 3, 3] } ],
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 0.12,
                    "material": { "type": "mirror", "color": "#f0f0f0" } } ] }
                """
                        .replace("WIDTH", Integer.toString(width));
        String said = reason(BuiltInMethod.RAYTRACE, SceneReader.readString(scene, Path.of(""), ""));
        assertEquals(isSmall, said.contains("small lamps"), said);
    }

    @ParameterizedTest
    @CsvSource({"0", "1", "5"})
    void aSmallLampBehindAPaneIsUndersampledHoweverFewBouncesThereAre(int bounces) {
        String scene =
                """
                { "image": { "width": 24, "height": 16 }, "shading": { "model": "physical", "maxBounces": BOUNCES },
                  "camera": { "type": "perspective", "eye": [0, 0, -6], "lookAt": [0, 0, 0], "fieldOfView": 40 },
                  "lights": [ { "type": "sphere", "center": [0.1, 0.1, 3], "radius": 0.02, "color": "#ffffff", "radiance": [3, 3, 3] } ],
                  "objects": [ { "type": "rectangle", "corners": [[-3, -3, 0], [-3, 3, 0], [3, 3, 0], [3, -3, 0]],
                    "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5 } } ] }
                """
                        .replace("BOUNCES", Integer.toString(bounces));
        String said = reason(BuiltInMethod.RAYTRACE, SceneReader.readString(scene, Path.of(""), ""));
        assertTrue(said.contains("small lamps"), said);
    }

    /** The scenes of the table in docs/notes/error-estimation.md. */
    @Test
    void theMeasuredScenesAreSaid() throws IOException {
        for (BuiltInMethod method : BuiltInMethod.values()) {
            for (String name : List.of("narrow-lobes", "narrow-lobes-2")) {
                assertTrue(reason(method, measured(name)).contains("narrow"), name);
            }
            String reason = reason(method, measured("cloudy-rough"));
            assertEquals(method == BuiltInMethod.LIGHT, !reason.isEmpty(), reason);
        }
    }

    private static Scene measured(String name) throws IOException {
        return SceneReader.read(Path.of("src/test/resources/physical/" + name + ".json"));
    }

    /** These have small lamps or the sun, and mirrors or glass in which they are seen; none has narrow chains. */
    @Test
    void onlyShippedScenesThatShowCausticsOfSmallLampsAreSaidToHaveSuchLight() throws IOException {
        Set<String> said = new TreeSet<>();
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("project.directory"), "scenes"))) {
            for (Path file :
                    files.filter(f -> f.toString().endsWith(".json")).sorted().toList()) {
                Scene scene = SceneReader.read(file);
                CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
                for (BuiltInMethod method : BuiltInMethod.values()) {
                    String reason = Method.supports(method, scene)
                            ? String.join("; ", Integrators.undersampled(method, compiled))
                            : "";
                    if (!reason.isEmpty()) {
                        String what = method == BuiltInMethod.LIGHT ? "small lamps" : "small lamps and caustics";
                        assertEquals("few paths find " + what + " that are seen in mirrors or through glass", reason);
                        said.add(file.getFileName().toString().replace(".json", ""));
                    }
                }
            }
        }
        assertEquals(
                Set.of(
                        "caustics",
                        "fire-and-ice-physical",
                        "fluorescent-poster",
                        "glass-and-prism",
                        "knot",
                        "lamp-room",
                        "panorama",
                        "prism",
                        "sky",
                        "terrace"),
                said);
    }
}

package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.SceneCompiler;
import enlightenment.plan.Integrators;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Budget;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures with motion blur: light that is left to chance counts as the mean over the moments, not as it is when the frame begins. */
class LeftAtMomentsTest {
    private static final String BODY =
            """
            { "type": "sphere", "center": [0, 1, 0], "radius": 1.2, "material": { "type": "scattering",
              "scatteringCoefficient": 4, "absorptionCoefficient": 0.05, "indexOfRefraction": 1.4 } }
            """;

    private static final String MIRROR =
            """
            { "type": "rectangle", "corners": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]], "material": "floor" },
            { "type": "sphere", "center": [0, 1.2, 0], "radius": 0.8,
              "material": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5 } },
            { "type": "rectangle", "corners": [[-4, 0, 3], [-4, 4, 3], [4, 4, 3], [4, 0, 3]],
              "material": { "type": "mirror", "color": "#f0f0f0" } }
            """;

    @TempDir
    static Path folder;

    /** A frame in which something goes from one number to another. */
    private static Scene frame(String objects, String target, double from, double to, int instants) {
        String file =
                """
                {
                  "image": { "width": 16, "height": 16 },
                  "camera": { "type": "perspective", "eye": [0, 1, -5], "lookAt": [0, 1, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "materials": { "floor": { "type": "matte", "color": "#cccccc" } },
                  "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.05, "color": "#ffffff",
                                "radiance": 4000 } ],
                  "objects": [ %s ],
                  "animation": { "frames": 2, "framesPerSecond": 25, "shutter": 1, "instants": %d,
                    "tracks": [ { "target": "%s", "keys": { "0": %s, "1": %s } } ] }
                }
                """
                        .formatted(objects, instants, target, from, to);
        try {
            Path path = Files.createTempFile(folder, "frame", ".json");
            Files.writeString(path, file);
            return SceneReader.read(path, 0);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static double leftToChance(Scene scene, BuiltInMethod method) {
        RenderSettings settings =
                RenderSettings.of(scene).withMethod(method).withThreads(2).withBudget(Budget.NONE.withSamples(16));
        RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        return result.report().sampling().light().orElseThrow().leftToChance();
    }

    private static double ofLamp(String objects, BuiltInMethod method, double from, double to, int instants) {
        return leftToChance(frame(objects, "/lights/0/radiance", from, to, instants), method);
    }

    /**
     * Lamps that go on and off have the light of one that stays in the mean, and are found as often; where more is found at a time, it
     * shows a little less.
     */
    @ParameterizedTest
    @CsvSource({"body, RAYTRACE, 4", "body, RAYTRACE, 40", "body, BIDIRECTIONAL, 4", "mirror, RAYTRACE, 4"})
    void aLampThatGoesOnOrOffLeavesAboutAsMuchToChanceAsOneThatStays(String name, BuiltInMethod method, int instants) {
        String objects = name.equals("body") ? BODY : MIRROR;
        double stays = ofLamp(objects, method, 4000, 4000, instants);
        assertTrue(stays > 0.01, stays + " is little");
        assertEquals(stays, ofLamp(objects, method, 0, 8000, instants), 0.15 * stays);
        assertEquals(stays, ofLamp(objects, method, 8000, 0, instants), 0.15 * stays);
    }

    @Test
    void aBodyThatComesIntoThePictureCounts() {
        double there = leftToChance(frame(BODY, "/objects/0/center/0", 0, 0, 8), BuiltInMethod.RAYTRACE);
        double comes = leftToChance(frame(BODY, "/objects/0/center/0", -6, 2, 8), BuiltInMethod.RAYTRACE);
        assertTrue(comes > 0.2 * there && comes < there, comes + " of " + there);
    }

    /** An index of refraction of 1 bends no light: when the frame begins there is neither a caustic nor anything to see it in. */
    @Test
    void whatAMethodCannotSeeIsToldOfAnyMoment() {
        Scene scene =
                frame(MIRROR.replace("\"mirror\"", "\"matte\""), "/objects/1/material/indexOfRefraction", 1, 1.6, 4);
        RenderSettings settings = RenderSettings.of(scene).withMethod(BuiltInMethod.LIGHT);
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        assertFalse(compiled.physical.showsMirrored);
        assertTrue(Integrators.blindSpot(BuiltInMethod.LIGHT, compiled).isPresent());
    }
}

package enlightenment.transport.bidirectional;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.primitive.Ray;
import enlightenment.render.Welch;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.transport.light.BidirectionalLightTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Where no mirror and no glass is in the way, each strategy alone finds all paths of a length, and without a weight: so all of them tell
 * the same mean of the picture, and so does any mixture by weights.
 */
class BidirectionalStrategiesTest {
    private static final int SIDE = 16;
    private static final int GROUPS = 16;
    private static final int SAMPLES = 12;

    private static final String SCENE =
            """
            { "image": { "width": 16, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 1, -3.4], "lookAt": [0, 0.9, 0], "fieldOfView": 36 },
              "shading": { "model": "physical" },
              "materials": {
                "white": { "type": "matte", "color": { "linear": [0.8, 0.8, 0.8] } },
                "clay": { "type": "matte", "color": { "linear": [0.7, 0.7, 0.7] }, "roughness": 0.8 },
                "metal": { "type": "glossy", "color": { "linear": [0.9, 0.9, 0.9] }, "roughness": 0.8 }
              },
              "lights": [LIGHT],
              "objects": [
                { "type": "rectangle", "corners": [[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]], "material": "white" },
                { "type": "rectangle", "corners": [[-1, 0, 1], [-1, 2, 1], [1, 2, 1], [1, 0, 1]], "material": "clay" },
                { "type": "rectangle", "corners": [[-1, 0, -1], [-1, 2, -1], [-1, 2, 1], [-1, 0, 1]], "material": "white" },
                { "type": "sphere", "center": [0.3, 0.45, 0], "radius": 0.4, "material": "metal" }
              ] }
            """;
    private static final String BALL =
            "{ \"type\": \"sphere\", \"center\": [-0.3, 1.4, 0.1], \"radius\": 0.35, \"color\": \"#ffffff\", \"radiance\": 2 }";
    private static final String PANEL =
            """
            { "type": "rectangle", "corners": [[-0.6, 1.9, 0.4], [-0.6, 1.9, -0.4], [0.5, 1.8, -0.4], [0.5, 1.8, 0.4]],
              "color": "#ffffff", "radiance": 2, "twoSided": false }
            """;

    private static CompiledScene scene(String light) {
        Scene scene = SceneReader.readString(SCENE.replace("LIGHT", light), Path.of(""), "");
        return SceneCompiler.compile(scene, RenderSettings.of(scene));
    }

    /** Means of the picture by independent groups of paths; s = −1 stands for all strategies with their weights. */
    private static double[] fromTheEye(CompiledScene scene, int s, int length) {
        BidirectionalTracer tracer = new BidirectionalTracer(scene, new RayCounters(scene.kindNames.size()));
        tracer.watch((i, t, weight) -> i + t != length ? 0 : s < 0 ? weight : i == s ? 1 : 0);
        double[] means = new double[GROUPS];
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        tracer.beginTile(0, 0, 1, 1);
        for (int g = 0; g < GROUPS; g++) {
            for (int k = 0; k < SIDE * SIDE * SAMPLES; k++) {
                int x = k % SIDE;
                int y = k / SIDE % SIDE;
                sampler.pixel(31L * (s + 2) + g, x, y);
                sampler.sample(k / (SIDE * SIDE));
                scene.camera.ray((x + sampler.filmX()) / SIDE, (y + sampler.filmY()) / SIDE, ray);
                tracer.shade(ray, sampler, color);
                means[g] += color[0] / (SIDE * SIDE * SAMPLES);
            }
        }
        return means;
    }

    private static double[] toTheEye(CompiledScene scene, boolean all, int length) {
        double[] means = new double[GROUPS];
        for (int g = 0; g < GROUPS; g++) {
            BidirectionalLightTracer tracer = new BidirectionalLightTracer(
                    scene, 97L * length + g, SIDE, SIDE, new RayCounters(scene.kindNames.size()));
            tracer.watch((s, t, weight) -> s + t != length ? 0 : all ? weight : 1);
            means[g] = tracer.meanContribution(SIDE * SIDE * SAMPLES);
        }
        return means;
    }

    @ParameterizedTest
    @ValueSource(strings = {BALL, PANEL})
    void eachOfThemAloneFindsTheSame(String light) {
        CompiledScene scene = scene(light);
        for (int length = 3; length <= 5; length++) {
            List<double[]> all = new ArrayList<>();
            for (int s = 0; s <= length - 2; s++) {
                all.add(fromTheEye(scene, s, length));
            }
            all.add(toTheEye(scene, false, length));
            double[] weighted = fromTheEye(scene, -1, length);
            double[] more = toTheEye(scene, true, length);
            for (int g = 0; g < GROUPS; g++) {
                weighted[g] += more[g];
            }
            all.add(weighted);
            double level = Welch.sidak(0.01, 2 * 3 * all.size());
            for (int s = 0; s < all.size() - 1; s++) {
                String what = length + " vertices, " + s + " from the light: " + mean(all.get(s)) + " instead of "
                        + mean(weighted);
                assertTrue(mean(weighted) > 0.001, what);
                assertTrue(Welch.of(all.get(s), weighted).probability() >= level, what);
            }
        }
    }

    private static double mean(double[] numbers) {
        double sum = 0;
        for (double n : numbers) {
            sum += n;
        }
        return sum / numbers.length;
    }
}

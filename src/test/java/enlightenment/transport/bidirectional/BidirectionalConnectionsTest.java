package enlightenment.transport.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How many vertices of two paths are connected with each other. */
class BidirectionalConnectionsTest {
    private static final int SAMPLES = 20_000;
    private static final int LONGEST = 60;

    /** From within a hollow ball, where each two points see each other, and light of a point that no path runs into. */
    private static final String SCENE =
            """
            { "image": { "width": 1, "height": 1 },
              "camera": { "type": "perspective", "eye": [0.3, 0, 0], "lookAt": [1, 0.2, 0], "fieldOfView": 60 },
              "shading": { "model": "physical" },
              "materials": { "wall": { "type": "matte", "color": { "linear": [ALBEDO, ALBEDO, ALBEDO] } } },
              "lights": [{ "type": "point", "position": [-0.2, 0.1, 0.1], "color": "#ffffff", "intensity": 1 }],
              "objects": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "wall" }] }
            """;

    /** How often paths of so many vertices were made by connections, per sample. */
    private static double[] connections(double albedo) {
        Scene scene = SceneReader.readString(SCENE.replace("ALBEDO", Double.toString(albedo)), Path.of(""), "");
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        BidirectionalTracer tracer = new BidirectionalTracer(compiled, new RayCounters(compiled.kindNames.size()));
        double[] found = new double[LONGEST + 1];
        tracer.watch((s, t, weight) -> {
            if (s >= 2 && s + t <= LONGEST) {
                found[s + t] += 1.0 / SAMPLES;
            }
            return weight;
        });
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        tracer.beginTile(0, 0, 1, 1);
        for (int k = 0; k < SAMPLES; k++) {
            sampler.pixel(7, k, 0);
            sampler.sample(0);
            compiled.camera.ray(0.5, 0.5, ray);
            tracer.shade(ray, sampler, new double[3]);
        }
        return found;
    }

    /**
     * A path of n vertices has n − 1 edges, of which all but the first at the eye and the first at the light can be a connection; the parts beside it are there
     * with the probability q each, from the second of their vertices on, for n − 4 in all.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.92})
    void ofEachLengthAFewPathsAreMadeInTheMeanHoweverManyThereAre(double albedo) {
        double[] found = connections(albedo);
        double q = Math.sqrt(albedo);
        int tested = 0;
        for (int n = 4; n <= LONGEST; n++) {
            int pairs = n - 3;
            double there = pairs * Math.pow(q, n - 4);
            double expected = there * Math.min(1, (double) BidirectionalGathering.PATHS_OF_A_LENGTH / (n - 1));
            if (expected * SAMPLES < 500) {
                break;
            }
            // However the pairs of a sample hang together: the square of their number is at most pairs² where the
            // shorter part is there.
            double deviation = Math.sqrt(pairs * there / SAMPLES);
            assertEquals(expected, found[n], 5 * deviation, n + " vertices");
            assertTrue(found[n] < BidirectionalGathering.PATHS_OF_A_LENGTH, n + " vertices: " + found[n]);
            tested++;
        }
        assertTrue(tested >= 8, tested + " lengths");
    }
}

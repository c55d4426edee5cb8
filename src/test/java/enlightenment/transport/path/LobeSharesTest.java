package enlightenment.transport.path;

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
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Paths by way of rough surfaces may share what they bring: their mean is what it was. */
class LobeSharesTest {
    private static final int SIZE = 32;

    /** Groups of paths through a small part of a picture. */
    private static final class Group {
        private final CompiledScene scene;
        private final PathIntegrator tracer;
        private final PathCut[] cuts = new PathCut[SIZE];
        private final SobolSampler sampler = new SobolSampler();
        private final Ray ray = new Ray();

        /**
         * Sums over groups of what their paths are worth whole, cut but alone, and shared; and of the squares of the differences from
         * whole.
         */
        private final double[] sums = new double[3];

        private final double[] differences = new double[3];

        /** Sums over paths of the squares of what they are worth alone, and shared. */
        private final double[] squares = new double[2];

        Group(String file) throws Exception {
            Scene described = SceneReader.read(Path.of(file));
            scene = SceneCompiler.compile(described, RenderSettings.of(described));
            tracer = new PathIntegrator(scene, new RayCounters(scene.kindNames.size()));
            tracer.beginTile(0, 0, 1, 1);
            Arrays.setAll(cuts, k -> new PathCut());
        }

        /** Takes a group of paths through a small part of the picture. */
        private void take(double x, double y, int number) {
            double[][] shared = new double[SIZE][3];
            double[] values = new double[3];
            double[] rgb = new double[3];
            for (int k = 0; k < SIZE; k++) {
                sampler.pixel(number, k, 0);
                sampler.sample(0);
                aim(x, y, k);
                tracer.shade(ray, sampler, rgb);
                values[0] += rgb[0] + rgb[1] + rgb[2];
                aim(x, y, k);
                tracer.shade(ray, sampler, cuts[k]);
                cuts[k].own(shared[k]);
                cuts[k].bringsAlone(rgb);
                for (int c = 0; c < 3; c++) {
                    double value = shared[k][c] + rgb[c];
                    values[1] += value;
                    squares[0] += value * value;
                }
            }
            tracer.connections().share(cuts, SIZE, shared);
            for (double[] color : shared) {
                values[2] += color[0] + color[1] + color[2];
                squares[1] += color[0] * color[0] + color[1] * color[1] + color[2] * color[2];
            }
            for (int w = 0; w < 3; w++) {
                sums[w] += values[w];
                differences[w] += (values[w] - values[0]) * (values[w] - values[0]);
            }
        }

        private void aim(double x, double y, int k) {
            scene.camera.ray(x + (k % 8) * 1e-3, y + (k / 8) * 2e-3, ray);
        }
    }

    /** Places: floor beside metal; metal that shows metal; both at an edge; rough walls with a glowing ball. */
    @ParameterizedTest
    @CsvSource({
        "scenes/metals.json, 0.42, 0.4",
        "scenes/metals.json, 0.395, 0.45",
        "scenes/metals.json, 0.56, 0.3",
        "scenes/metals.json, 0.3, 0.5",
        "scenes/lamp-room.json, 0.3, 0.3",
        "scenes/lamp-room.json, 0.7, 0.15",
        "scenes/furnace.json, 0.4, 0.5"
    })
    void whatIsSharedIsInTheMeanWhatPathsBringAlone(String file, double x, double y) throws Exception {
        Group group = new Group(file);
        int count = 1500;
        for (int n = 0; n < count; n++) {
            group.take(x, y, n);
        }
        for (int w = 1; w < 3; w++) {
            double mean = (group.sums[w] - group.sums[0]) / count;
            double deviation = Math.sqrt(group.differences[w] / count / count);
            String what = (w == 1 ? "alone " : "shared ") + mean + " +- " + deviation + " of " + group.sums[0] / count;
            assertTrue(Math.abs(mean) <= 4 * deviation + 1e-12 * group.sums[0] / count, what);
            assertTrue(deviation < 0.01 * group.sums[0] / count, what);
        }
    }

    @ParameterizedTest
    @CsvSource({"scenes/metals.json, 0.56, 0.3", "scenes/metals.json, 0.3, 0.5", "scenes/lamp-room.json, 0.3, 0.3"})
    void pathsAreLessNoisyForIt(String file, double x, double y) throws Exception {
        Group group = new Group(file);
        for (int n = 0; n < 1000; n++) {
            group.take(x, y, n);
        }
        // Of two variables with the same mean the one with the smaller mean square has the smaller variance.
        assertTrue(group.squares[1] < group.squares[0], group.squares[1] + " is not below " + group.squares[0]);
    }

    @Test
    void aPathThatSharesWithNoneIsWorthWhatItIsAlone() throws Exception {
        Group group = new Group("scenes/metals.json");
        double[] alone = new double[3];
        int given = 0;
        for (int n = 0; n < 3000; n++) {
            group.sampler.pixel(n, 0, 0);
            group.sampler.sample(0);
            group.aim((n % 50 + 0.5) / 50, (n / 50 + 0.5) / 60, 0);
            group.tracer.shade(group.ray, group.sampler, group.cuts[0]);
            if (group.cuts[0].gives()) {
                given++;
                double[][] taken = new double[1][3];
                group.cuts[0].bringsAlone(alone);
                group.tracer.connections().share(group.cuts, 1, taken);
                for (int c = 0; c < 3; c++) {
                    assertEquals(alone[c], taken[0][c], 1e-9 * alone[c]);
                }
            }
        }
        assertTrue(given > 500, given + " of 3000 give");
    }
}

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
import org.junit.jupiter.api.Test;

/** Paths that are cut at their second vertex are the same paths. */
class PathCutTest {
    @Test
    void aPathThatGetsAllThatItGivesIsWorthWhatItIsWhole() throws Exception {
        Scene described = SceneReader.read(Path.of("scenes/fire-and-ice-physical.json"));
        CompiledScene scene = SceneCompiler.compile(described, RenderSettings.of(described));
        PathIntegrator tracer = new PathIntegrator(scene, new RayCounters(scene.kindNames.size()));
        tracer.beginTile(0, 0, 1, 1);
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        PathCut cut = new PathCut();
        double[] whole = new double[3];
        double[] own = new double[3];
        double[] certain = new double[3];
        double[] alone = new double[3];
        double[] again = new double[3];
        int given = 0;
        int differ = 0;
        double sum = 0;
        double sumOfWhole = 0;
        for (int k = 0; k < 2000; k++) {
            double x = (k % 50 + 0.5) / 50;
            double y = (k / 50 + 0.5) / 40;
            sampler.pixel(1, k, 0);
            sampler.sample(k % 7);
            scene.camera.ray(x, y, ray);
            tracer.shade(ray, sampler, whole);
            long key = tracer.certain(certain);
            scene.camera.ray(x, y, ray);
            tracer.shade(ray, sampler, cut);
            cut.own(own);
            assertEquals(key, tracer.certain(again));
            if (cut.gives()) {
                given++;
                cut.bringsAlone(alone);
                double[][] taken = new double[1][3];
                tracer.connections().share(new PathCut[] {cut}, 1, taken);
                for (int c = 0; c < 3; c++) {
                    assertEquals(alone[c], taken[0][c], 1e-15 * taken[0][c]);
                }
            }
            cut.bringsAlone(alone);
            for (int c = 0; c < 3; c++) {
                double value = own[c] + alone[c];
                sum += value;
                sumOfWhole += whole[c];
                // Roulette sees a throughput without the first albedo, so that faint paths end elsewhere.
                differ += Math.abs(value - whole[c]) <= 1e-12 * Math.max(whole[c], 1e-3) ? 0 : 1;
                assertEquals(certain[c], again[c]);
            }
            scene.camera.ray(x, y, ray);
            tracer.glimpse(ray, sampler);
            assertEquals(key, tracer.certain(again));
            assertEquals(certain[0], again[0]);
        }
        assertTrue(given > 1000, given + " of 2000 give");
        assertTrue(differ < 2400, differ + " of 6000 differ");
        assertEquals(sumOfWhole, sum, 1e-3 * sumOfWhole);
    }
}

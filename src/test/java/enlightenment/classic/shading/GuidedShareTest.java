package enlightenment.classic.shading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.render.TestScenes;
import enlightenment.sampling.SobolSampler;
import enlightenment.sampling.Warp;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Importance sampling of light points by a guide leaves the mean colour unchanged. */
class GuidedShareTest {
    /** A floor below a ball light of which a screen leaves about a tenth. */
    private static Scene scene(double tilt) {
        return Scene.builder()
                .size(1, 1)
                .camera(new Camera.Orthographic(ExactPoint.of(0, 3, 0), ExactPoint.of(0, 0, 0), Vec3.Z, 0.001))
                .shading(new Shading.Classic(0, 0, DisplayRgb.BLACK, 10))
                .object(
                        TestScenes.rectangle(-9, -9 * tilt, -9, -9, -9 * tilt, 9, 9, 9 * tilt, 9, 9, 9 * tilt, -9),
                        TestScenes.matte(1, 1, 1))
                .object(TestScenes.rectangle(-0.35, 5, -9, -0.35, 5, 9, 9, 5, 9, 9, 5, -9), TestScenes.matte(1, 1, 1))
                .light(new Light.Sphere(ExactPoint.of(0, 10, 0), 1, DisplayRgb.WHITE))
                .build();
    }

    /** Takes three quarters of the points from one half of the disk. */
    private static final class Skewed implements LightGuide {
        private final boolean blocked;
        private final double[] disk = new double[3];

        Skewed(boolean blocked) {
            this.blocked = blocked;
        }

        @Override
        public boolean begin(int surface, int light, int bounce) {
            return true;
        }

        @Override
        public double propose(double u, double v) {
            boolean left = u < 0.75;
            Warp.toDisk(left ? u / 0.75 : 4 * (u - 0.75), v, disk);
            disk[0] = left ? -Math.abs(disk[0]) : Math.abs(disk[0]);
            return left ? 2.0 / 3 : 2;
        }

        @Override
        public double p() {
            return disk[0];
        }

        @Override
        public double q() {
            return disk[1];
        }

        @Override
        public boolean wantsBlocked() {
            return blocked;
        }
    }

    private int told;

    private double[] meanAndError(CompiledScene compiled, LightGuide guide, int points, int runs) {
        ClassicShader shader = new ClassicShader(compiled, points, new RayCounters(compiled.kindNames.size()));
        shader.beginTile(0, 0, 1, 1);
        shader.guide(guide);
        Ray ray = new Ray();
        SobolSampler address = new SobolSampler();
        double[] color = new double[3];
        double sum = 0;
        double squares = 0;
        for (int k = 0; k < runs; k++) {
            address.pixel(k, 0, 0);
            address.sample(0);
            compiled.camera.ray(0.5, 0.5, ray);
            shader.shade(ray, address, color);
            sum += color[1];
            told += shader.report().guided.size();
            assertEquals(shader.report().shadowRays, points, "all are partly hidden");
            squares += color[1] * color[1];
        }
        double mean = sum / runs;
        return new double[] {mean, Math.sqrt((squares / runs - mean * mean) / runs)};
    }

    @ParameterizedTest
    @CsvSource({"true, 1, 0", "false, 1, 0", "true, 4, 0.3", "false, 4, 0.3", "false, 1, -0.5", "true, 1, -0.5"})
    void aGuideDoesNotChangeTheMeanColour(boolean blocked, int points, double tilt) {
        Scene scene = scene(tilt);
        CompiledScene compiled = SceneCompiler.compile(scene, RenderSettings.of(scene));
        Skewed guide = new Skewed(blocked);
        double[] guided = meanAndError(compiled, guide, points, 100_000);
        assertEquals(100_000 * points, told);
        double[] even = meanAndError(compiled, null, 64, 20_000);
        assertEquals(100_000 * points, told, "without a guide none is guided");
        assertTrue(even[0] > 0.02 && even[0] < 0.6, "partly hidden: " + even[0]);
        assertEquals(even[0], guided[0], 4 * Math.sqrt(guided[1] * guided[1] + even[1] * even[1]));
        assertTrue(guided[1] < 0.005 * Math.max(1, 4 * even[0]), "too noisy to tell: " + guided[1]);
    }
}

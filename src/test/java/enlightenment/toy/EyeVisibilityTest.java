package enlightenment.toy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Test;

/** What points on the balls say of the eye is what rays from the eye say of the balls. */
class EyeVisibilityTest {
    private static final Scene BALLS = ToyScene.scene();

    private static RenderResult splats(double samples, long seed) {
        RenderSettings settings = RenderSettings.of(BALLS)
                .withMethod(Method.named(EyeVisibility.WORD))
                .withSeed(seed)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        return Renderer.render(RenderRequest.of(BALLS, settings));
    }

    private static double rmse(Image a, Image b) {
        float[] p = a.toArray();
        float[] q = b.toArray();
        double sum = 0;
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (double) (p[i] - q[i]);
        }
        return Math.sqrt(sum / p.length);
    }

    @Test
    void splatsConvergeToWhatTheEyeSeesAndTellTheirError() {
        Image seen = Renderer.render(BALLS, RenderSettings.of(BALLS));
        for (double samples : new double[] {64, 1024}) {
            int kept = 0;
            for (int seed = 1; seed <= 5; seed++) {
                RenderResult result = splats(samples, seed);
                RenderReport.Sampling said = result.report().sampling();
                double error = rmse(seen, result.image());
                // 256 stratified samples leave a small error in what is taken for the truth.
                kept += error >= 0.8 * said.errorLow() && error <= 1.1 * said.errorHigh() ? 1 : 0;
                assertTrue(result.complete());
            }
            // Each interval is to hold the error in 95 of 100 renders; that two of five miss it has a chance of 0.02.
            assertTrue(kept >= 4, samples + ": " + kept + " of 5");
        }
    }

    @Test
    void sixteenTimesThePathsHaveAQuarterOfTheError() {
        Image seen = Renderer.render(BALLS, RenderSettings.of(BALLS));
        double few = rmse(seen, splats(16, 1).image());
        double many = rmse(seen, splats(256, 2).image());
        assertEquals(4, few / many, 0.6);
    }
}

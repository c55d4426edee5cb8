package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.image.Image;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * Errors of pictures whose paths have one choice only, between light and nothing. The numbers that choose are stratified, so all of n
 * samples but one are certain: the variance of their mean is {np}(1 − {np})/n² with the fractional part {np}, which goes up and down from
 * one power of two to the next. What differences of halves and quarters tell of it is not how it goes on.
 */
class ChosenLightErrorTest {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;
    private static final double GLOW = 0.5;

    /** A pane that lets this share of the light of what is behind it pass, and is black for the rest. */
    private static Scene pane(double share) throws Exception {
        return SceneReader.readString(
                String.format(
                        Locale.ROOT,
                        """
                        {"image": {"width": %d, "height": %d}, "shading": {"model": "physical"},
                         "camera": {"type": "orthographic", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "height": 2},
                         "objects": [
                          {"type": "rectangle", "corners": [[-4, -4, 0], [-4, 4, 0], [4, 4, 0], [4, -4, 0]],
                           "material": {"type": "glass", "color": {"linear": [1, 1, 1]}, "indexOfRefraction": 1, "transparency": %s}},
                          {"type": "rectangle", "corners": [[-4, -4, 1], [-4, 4, 1], [4, 4, 1], [4, -4, 1]],
                           "material": {"type": "matte", "color": "#000", "radiance": %s}}]}
                        """,
                        WIDTH,
                        HEIGHT,
                        share,
                        GLOW),
                Path.of(""),
                "pane");
    }

    private static RenderResult render(Scene scene, RenderSettings.Budget budget, long seed) {
        RenderSettings settings =
                RenderSettings.of(scene).withThreads(1).withBudget(budget).withSeed(seed);
        return Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
    }

    /** The root mean square error, as shown. */
    private static double error(Image image, double truth) {
        float[] rgb = image.toArray();
        double squares = 0;
        for (float value : rgb) {
            double d = TransferCurve.encode(Math.min(value, 1)) - TransferCurve.encode(truth);
            squares += d * d / rgb.length;
        }
        return Math.sqrt(squares);
    }

    @Test
    void theVarianceIsThatOfStratifiedNumbers() throws Exception {
        double p = 0.3;
        int n = 8;
        float[] rgb = render(pane(p), RenderSettings.Budget.NONE.withSamples(n), 1)
                .image()
                .toArray();
        double squares = 0;
        for (float value : rgb) {
            squares += (value - p * GLOW) * (value - p * GLOW) / rgb.length;
        }
        double part = n * p - Math.floor(n * p);
        assertEquals(1, squares / (GLOW * GLOW * part * (1 - part) / (n * n)), 0.2);
    }

    @Test
    void theIntervalHoldsTheErrorWhateverTheShareOfLight() throws Exception {
        int pictures = 0;
        List<String> low = new ArrayList<>();
        List<String> high = new ArrayList<>();
        for (int percent = 5; percent < 100; percent += 5) {
            Scene scene = pane(percent / 100.0);
            for (int n : new int[] {4, 6, 8, 9, 12, 16, 32, 64, 100, 128, 256}) {
                RenderResult result = render(scene, RenderSettings.Budget.NONE.withSamples(n), 1);
                double error = error(result.image(), GLOW * percent / 100);
                RenderReport.Sampling told = result.report().sampling();
                pictures++;
                String said = String.format(
                        Locale.ROOT,
                        "%d %%, %d samples: %.5f, told %.5f, %.5f to %.5f",
                        percent,
                        n,
                        error,
                        told.estimatedError(),
                        told.errorLow(),
                        told.errorHigh());
                if (error > told.errorHigh()) {
                    high.add(said);
                }
                if (error < told.errorLow()) {
                    low.add(said);
                }
            }
        }
        assertTrue(high.size() <= 0.02 * pictures, () -> high.size() + " " + String.join("\n", high));
        // Half of all cases cannot be told from independent samples, so what is told may be far too much.
        assertTrue(low.size() <= 0.5 * pictures, () -> low.size() + " " + String.join("\n", low));
    }

    @Test
    void anErrorThatIsAskedForIsKept() throws Exception {
        for (double share : new double[] {0.3, 0.6, 0.72}) {
            Scene scene = pane(share);
            for (double asked : new double[] {0.03, 0.02}) {
                RenderResult result = render(scene, RenderSettings.Budget.NONE.withError(asked), 1);
                double error = error(result.image(), GLOW * share);
                assertTrue(error <= asked, () -> share + ": " + error + " for " + asked);
            }
        }
    }
}

package enlightenment.view.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Means of passes, and what their spread says of the error, against closed forms. */
class PictureSumTest {
    private static final int SIDE = 64;

    private static Image plain(int width, int height, float value, Color.Encoding encoding) {
        float[] rgb = new float[3 * width * height];
        java.util.Arrays.fill(rgb, value);
        return new Image(width, height, rgb, encoding);
    }

    /** Independent normal components of mean 0.5. */
    private static Image noise(Random random, double deviation) {
        float[] rgb = new float[3 * SIDE * SIDE];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (0.5 + deviation * random.nextGaussian());
        }
        return new Image(SIDE, SIDE, rgb);
    }

    @Test
    void onePassSaysNothingOfItsError() {
        PictureSum sum = new PictureSum();
        sum.add(plain(2, 2, 1, Color.Encoding.DISPLAY), 1);
        assertTrue(sum.noise().isEmpty());
    }

    @Test
    void theMeanIsWeighted() {
        PictureSum sum = new PictureSum();
        sum.add(plain(2, 1, 1, Color.Encoding.DISPLAY), 1);
        sum.add(plain(2, 1, 4, Color.Encoding.DISPLAY), 2);
        assertEquals(3, sum.add(plain(2, 1, 3, Color.Encoding.DISPLAY), 3).component(1, 0, 2));
    }

    /** Of two passes a and b of one weight the mean deviates by |a − b|/2, from a to b: on a screen by half of what lies between. */
    @Test
    void ofTwoPassesTheErrorIsHalfTheirDifference() {
        PictureSum display = new PictureSum();
        display.add(plain(3, 3, 0.2f, Color.Encoding.DISPLAY), 1);
        display.add(plain(3, 3, 0.6f, Color.Encoding.DISPLAY), 1);
        assertEquals(0.2, display.noise().orElseThrow().rmse(DisplayCurve.NONE), 1e-7);
        PictureSum linear = new PictureSum();
        linear.add(plain(3, 3, 0.1f, Color.Encoding.LINEAR), 4);
        linear.add(plain(3, 3, 1.5f, Color.Encoding.LINEAR), 4);
        double expected = (1 - DisplayCurve.SRGB.of(0.1f)) / 2;
        PictureNoise noise = linear.noise().orElseThrow();
        assertEquals(expected, noise.rmse(DisplayCurve.SRGB), 1e-5);
        assertEquals(0.7, noise.deviation(1, 1, 0), 1e-6);
        // Two stops darker nothing is cut off.
        DisplayCurve dark = DisplayCurve.SRGB.withExposure(-2);
        assertEquals((dark.of(1.5f) - dark.of(0.1f)) / 2, noise.rmse(dark), 1e-5);
    }

    /** With n normal numbers the estimated variance deviates by √(2/n) of itself: 5 % is more than four deviations. */
    @Test
    void aKnownVarianceIsFound() {
        int[][] plans = {{1, 1}, {1, 1, 1, 1, 1, 1}, {1, 1, 2, 4, 8, 8, 8}, {1, 1, 2, 4, 2, 2, 1, 1}};
        Random random = new Random(7);
        for (int[] plan : plans) {
            PictureSum sum = new PictureSum();
            int samples = 0;
            for (int n : plan) {
                sum.add(noise(random, 0.1 / Math.sqrt(n)), n);
                samples += n;
            }
            double expected = 0.1 / Math.sqrt(samples);
            double found = sum.noise().orElseThrow().rmse(DisplayCurve.NONE);
            assertEquals(1, found * found / (expected * expected), 0.05, samples + " samples");
        }
    }

    /** Passes may be better than their number of samples says: variances as 1/n². The last pass is half of the mean, and of deviation 0.1/8. */
    @Test
    void twoHalvesNeedNoLawOfTheirVariance() {
        Random random = new Random(8);
        PictureSum sum = new PictureSum();
        for (int n : new int[] {1, 1, 2, 4, 8}) {
            sum.add(noise(random, 0.1 / n), n);
        }
        // Weighted by n/16 each pass adds 0.1²/16² to the variance.
        double expected = 5 * 0.1 * 0.1 / (16 * 16);
        double found = sum.noise().orElseThrow().rmse(DisplayCurve.NONE);
        assertEquals(1, found * found / expected, 0.05);
    }

    @Test
    void theMapIsSmoothedOverNeighbours() {
        float[] one = new float[3 * 25];
        one[3 * 12] = one[3 * 12 + 1] = one[3 * 12 + 2] = 0.6f;
        PictureSum sum = new PictureSum();
        sum.add(new Image(5, 5, one), 1);
        sum.add(plain(5, 5, 0, Color.Encoding.DISPLAY), 1);
        PictureNoise noise = sum.noise().orElseThrow();
        Image map = noise.map(DisplayCurve.NONE);
        assertEquals(0.1, map.component(1, 1, 0), 1e-6);
        assertEquals(0.1, map.component(2, 3, 2), 1e-6);
        assertEquals(0, map.component(0, 2, 0));
        assertEquals(0.3 / 5, noise.rmse(DisplayCurve.NONE), 1e-6);
    }

    /** Every other row and column of it: components of variance 0.1²/2. */
    @Test
    void theErrorOfALargePictureIsThatOfItsGrid() {
        Random random = new Random(9);
        PictureSum sum = new PictureSum();
        for (int pass = 0; pass < 2; pass++) {
            float[] rgb = new float[3 * 512 * 400];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = (float) (0.5 + 0.1 * random.nextGaussian());
            }
            sum.add(new Image(512, 400, rgb), 1);
        }
        double found = sum.noise().orElseThrow().rmse(DisplayCurve.NONE);
        assertEquals(1, found * found / 0.005, 0.02);
    }

    /** The estimate against what is measured from a picture of many samples, over several seeds. */
    @Test
    void theEstimateIsNearTheErrorOfRealPasses() {
        Scene scene = SceneReader.read(Path.of("scenes", "cornell-box.json"));
        RenderSettings usual = RenderSettings.of(scene);
        RenderSettings small = usual.withSize(24, 24);
        Image truth = Renderer.render(
                scene, small.withSeed(1).withBudget(usual.budget().withSamples(256)));
        double estimated = 0;
        double measured = 0;
        for (int seed = 0; seed < 12; seed++) {
            PictureSum sum = new PictureSum();
            Image mean = null;
            int number = 0;
            for (int n : new int[] {1, 1, 2, 4}) {
                RenderSettings pass = small.withSeed(1000 + 10 * seed + number++)
                        .withBudget(usual.budget().withSamples(n));
                mean = sum.add(Renderer.render(scene, pass), n);
            }
            estimated += Math.pow(sum.noise().orElseThrow().rmse(mean.curve()), 2);
            measured += squared(mean, truth);
        }
        double ratio = Math.sqrt(estimated / measured);
        assertTrue(ratio > 0.8 && ratio < 1.25, "estimated " + ratio + " of what it is");
        assertFalse(Double.isNaN(ratio));
    }

    private static double squared(Image a, Image b) {
        double sum = 0;
        for (int i = 0; i < a.width() * a.height(); i++) {
            for (int c = 0; c < 3; c++) {
                double off =
                        a.displayed(i % a.width(), i / a.width(), c) - b.displayed(i % a.width(), i / a.width(), c);
                sum += off * off;
            }
        }
        return sum / (3.0 * a.width() * a.height());
    }
}

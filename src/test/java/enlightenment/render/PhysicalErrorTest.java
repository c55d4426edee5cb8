package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.report.RenderReport;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Whether pictures of physical light are as exact as they are asked to be. What is true is told by pictures with other seeds: the mean of
 * k − 1 of them, as shown, errs by 1/√(k − 1) of what one does.
 */
class PhysicalErrorTest {
    /** What became of some pictures of the same scene. */
    private record Outcome(int pictures, int kept, int inside, int warned, double error, double samples) {
        @Override
        public String toString() {
            return String.format(
                    Locale.ROOT,
                    "%d of %d kept, %d in the interval, %d warned, error %.5f with %.0f samples",
                    kept,
                    pictures,
                    inside,
                    warned,
                    error,
                    samples);
        }
    }

    private static Outcome ask(String name, int width, int height, double error, int seeds) throws Exception {
        Scene scene = SceneReader.read(Path.of("src/test/resources/physical/" + name + ".json"));
        RenderSettings settings = RenderSettings.of(scene)
                .withSize(width, height)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withError(error));
        List<RenderResult> results = new ArrayList<>();
        for (int seed = 1; seed <= seeds; seed++) {
            results.add(Renderer.render(scene, settings.withSeed(seed), RenderProgress.NONE, () -> false));
        }
        double[] sum = new double[3 * width * height];
        for (RenderResult result : results) {
            float[] rgb = result.image().toArray();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += rgb[i];
            }
        }
        int kept = 0;
        int inside = 0;
        int warned = 0;
        double squares = 0;
        double samples = 0;
        for (RenderResult result : results) {
            double e = error(result.image(), sum, seeds);
            RenderReport.Sampling s = result.report().sampling();
            kept += e <= error ? 1 : 0;
            inside += e >= s.errorLow() && e <= s.errorHigh() ? 1 : 0;
            warned += s.light().orElseThrow().heavyTail() ? 1 : 0;
            squares += e * e / seeds;
            samples += s.samplesPerPixel() / seeds;
        }
        return new Outcome(seeds, kept, inside, warned, Math.sqrt(squares), samples);
    }

    /** The root mean square difference, as shown, from the mean of all others, without the error of that. */
    private static double error(Image image, double[] sum, int pictures) {
        float[] rgb = image.toArray();
        double squares = 0;
        for (int i = 0; i < rgb.length; i++) {
            double others = (sum[i] - rgb[i]) / (pictures - 1);
            double d = image.curve().of(rgb[i]) - image.curve().of(others);
            squares += d * d / rgb.length;
        }
        return Math.sqrt(squares * (pictures - 1) / pictures);
    }

    @Test
    void anErrorThatIsAskedForIsKept() throws Exception {
        Outcome outcome = ask("cornell", 64, 64, 0.03, 5);
        assertTrue(outcome.kept >= 4, outcome::toString);
    }

    /** A picture that a first sample shows black is not taken for one without noise, nor few pixels for certain to be wrong. */
    @Test
    void itIsKeptWhereFourPixelsCarryTheErrorAndNotByVeryManySamples() throws Exception {
        Outcome outcome = ask("spot", 32, 32, 0.004, 8);
        // By 36 samples the error is that in the root mean square.
        assertTrue(outcome.kept >= 7 && outcome.samples < 30 * 36, outcome::toString);
    }

    @Tag("full")
    @ParameterizedTest
    @CsvSource({
        "spot, 32, 32, 0.004",
        "spot, 32, 32, 0.002",
        "cornell, 64, 64, 0.02",
        "cornell, 64, 64, 0.01",
        "cornell, 64, 64, 0.005",
        "metals, 96, 48, 0.02",
        "metals, 96, 48, 0.01",
        "metals, 96, 48, 0.005",
        "room, 96, 48, 0.02",
        "room, 96, 48, 0.01",
        "room, 96, 48, 0.005",
    })
    void itIsKeptOnManySeeds(String scene, int width, int height, double error) throws Exception {
        Outcome outcome = ask(scene, width, height, error, 20);
        System.out.println(scene + " " + error + ": " + outcome);
        assertTrue(outcome.kept >= 19, outcome::toString);
    }
}

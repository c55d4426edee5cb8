import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.report.RenderReport;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.Locale;

/**
 * How many pictures err by more than the upper end of their interval, and how many of these go without a warning:
 *
 * <pre>
 * java -cp target/enlightenment.jar src/bench/scripts/IntervalCoverage.java SCENE REFERENCE.pfm METHOD[,METHOD...] BUDGET[,BUDGET...] SEEDS
 * </pre>
 *
 * A budget is a number of samples, or {@code e} and an error that is asked for. Seeds are 1 to SEEDS. The reference is linear light of a
 * render of the scene whose own error is small beside theirs.
 */
public final class IntervalCoverage {
    private IntervalCoverage() {}

    public static void main(String[] arguments) throws Exception {
        Scene scene = SceneReader.read(Path.of(arguments[0]));
        float[] reference =
                ImageFiles.read(Path.of(arguments[1]), Color.Encoding.LINEAR).toArray();
        for (String method : arguments[2].split(",")) {
            RenderSettings settings =
                    RenderSettings.of(scene).withMethod(BuiltInMethod.valueOf(method.toUpperCase(Locale.ROOT)));
            for (String budget : arguments[3].split(",")) {
                measure(scene, reference, settings, budget, Integer.parseInt(arguments[4]));
            }
        }
    }

    private static void measure(Scene scene, float[] reference, RenderSettings settings, String budget, int seeds) {
        boolean isError = budget.startsWith("e");
        double number = Double.parseDouble(isError ? budget.substring(1) : budget);
        RenderSettings.Budget limit =
                isError ? RenderSettings.Budget.NONE.withError(number) : RenderSettings.Budget.NONE.withSamples(number);
        int above = 0;
        int heavy = 0;
        int unwarned = 0;
        int kept = 0;
        double worst = 0;
        for (int seed = 1; seed <= seeds; seed++) {
            RenderResult result =
                    Renderer.render(scene, settings.withBudget(limit).withSeed(seed), RenderProgress.NONE, () -> false);
            double error = error(result.image(), reference);
            RenderReport.Sampling s = result.report().sampling();
            RenderReport.Light light = s.light().orElseThrow();
            boolean isAbove = error > s.errorHigh();
            above += isAbove ? 1 : 0;
            heavy += light.heavyTail() ? 1 : 0;
            unwarned += isAbove && !light.heavyTail() && light.undersampled().isEmpty() ? 1 : 0;
            kept += isError && error <= number ? 1 : 0;
            worst = Math.max(worst, error / s.errorHigh());
            System.out.printf(
                    Locale.ROOT,
                    "%d: true %.5f, estimated %.5f, up to %.5f, kurtosis %.1f, %s%.0f samples%n",
                    seed,
                    error,
                    s.estimatedError(),
                    s.errorHigh(),
                    light.kurtosis(),
                    light.heavyTail() ? "heavy tail, " : "",
                    s.samplesPerPixel());
        }
        System.out.printf(
                Locale.ROOT,
                "%s %s: %d of %d above (worst %.2f), %d of these without a warning; %d with a heavy tail%s%n",
                settings.method().word(),
                budget,
                above,
                seeds,
                worst,
                unwarned,
                heavy,
                isError ? "; " + kept + " kept" : "");
    }

    /** Root mean square difference, as shown. */
    private static double error(Image image, float[] reference) {
        float[] rgb = image.toArray();
        double squares = 0;
        for (int i = 0; i < rgb.length; i++) {
            double d = image.curve().of(rgb[i]) - image.curve().of(reference[i]);
            squares += d * d / rgb.length;
        }
        return Math.sqrt(squares);
    }
}

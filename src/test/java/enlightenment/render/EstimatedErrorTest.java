package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.ManySeeds.Picture;
import enlightenment.report.RenderReport;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The error that a render reports is that which it has, against a converged picture. */
class EstimatedErrorTest {
    private static final int SEEDS = 10;

    private record Budgeted(Method method, double samples) {}

    private static final List<Budgeted> FEW = List.of(
            new Budgeted(Method.RAYTRACE, 1),
            new Budgeted(Method.RAYTRACE, 2),
            new Budgeted(Method.RAYTRACE, 4),
            new Budgeted(Method.CLUSTER, 3));

    private static final List<Budgeted> ALL = List.of(
            new Budgeted(Method.RAYTRACE, 1),
            new Budgeted(Method.RAYTRACE, 2),
            new Budgeted(Method.RAYTRACE, 2.5),
            new Budgeted(Method.RAYTRACE, 4),
            new Budgeted(Method.RAYTRACE, 8),
            new Budgeted(Method.CLUSTER, 3),
            new Budgeted(Method.CLUSTER, 8));

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice", "keyhole"})
    void theEstimateIsNearTheTruthWithFewSamplesToo(String name) {
        // The error of 128 samples is at most a sixth of that of four: differences from them are 1.5 % larger than from
        // the truth.
        check(name, FEW, 128, 128);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"fire-and-ice", "torus", "keyhole"})
    void norIsItFarOffWithMore(String name) {
        check(name, ALL, 512, 200);
    }

    private static void check(String name, List<Budgeted> cases, int finest, int width) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings base =
                RenderSettings.of(scene).withSize(width, width / 2).withThreads(2);
        double[] truth = ManySeeds.render(
                        scene,
                        base.withMethod(Method.RAYTRACE)
                                .withSeed(424242)
                                .withBudget(RenderSettings.Budget.NONE.withSamples(finest)))
                .rgb();
        List<String> failures = new ArrayList<>();
        for (Budgeted c : cases) {
            RenderSettings s = base.withMethod(c.method).withBudget(RenderSettings.Budget.NONE.withSamples(c.samples));
            List<Picture> pictures = ManySeeds.render(scene, s, 1, SEEDS);
            double[] ratios = new double[SEEDS];
            int held = 0;
            for (int k = 0; k < SEEDS; k++) {
                RenderReport.Sampling sampling = pictures.get(k).sampling();
                double error = distance(pictures.get(k).rgb(), truth);
                ratios[k] = sampling.estimatedError() / error;
                held += error >= sampling.errorLow() && error <= sampling.errorHigh() ? 1 : 0;
            }
            Arrays.sort(ratios);
            double median = (ratios[SEEDS / 2 - 1] + ratios[SEEDS / 2]) / 2;
            String line = String.format(
                    "%s %s %.1f: estimated over true %.2f, in the interval %d of %d",
                    name, c.method, c.samples, median, held, SEEDS);
            // 9.5 expected; 7 or fewer have a probability of 1 %.
            // The torus with two samples is estimated a sixth too high.
            if (!(median > 0.87 && median < 1.2 && held > 7)) {
                failures.add(line);
            }
        }
        assertTrue(failures.isEmpty(), String.join("\n", failures));
    }

    private static double distance(double[] a, double[] b) {
        return Math.sqrt(IntStream.range(0, a.length)
                        .mapToDouble(k -> (a[k] - b[k]) * (a[k] - b[k]))
                        .sum()
                / a.length);
    }
}

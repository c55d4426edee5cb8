package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.film.FilmTile;
import enlightenment.film.SampleSpread;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Trials of a picture of plain noise, whose error is known. */
class ErrorTrialsTest {
    private static final double MOST = 1 << 24;

    private static RenderSettings settings(int width, int height, RenderSettings.Budget budget) {
        return RenderSettings.of(TestScenes.whiteFireAndIce().build())
                .withSize(width, height)
                .withBudget(budget);
    }

    /** Independent samples of this deviation, in each component alike; powers of two as raytrace takes them. */
    private static ErrorTrials.Sampler noise(double deviation) {
        SplittableRandom random = new SplittableRandom(11);
        return (n, blocks) -> blocks.forEach(block -> fill(block, n, deviation, random));
    }

    private static void fill(FilmTile block, double n, double deviation, SplittableRandom random) {
        SampleSpread spread = new SampleSpread();
        int low = Integer.highestOneBit((int) Math.min(n, 1 << 12));
        double doubled = Math.min(n, 1 << 12) / low - 1;
        // Means that lie evenly between the steps of a file.
        double mean = 0.4 + 0.1 * random.nextDouble();
        for (int y = block.y; y < block.y + block.height; y++) {
            for (int x = block.x; x < block.x + block.width; x++) {
                int samples = random.nextDouble() < doubled ? 2 * low : low;
                spread.begin(samples);
                for (int s = 0; s < samples; s++) {
                    double v = mean + deviation * random.nextGaussian();
                    block.add(x, y, v, v, v);
                    spread.add(v, v, v);
                }
                block.spread(x, y, spread);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"800, 400", "320, 200", "200, 100", "128, 64"})
    void theNumberFoundIsEnoughAndTheTrialsTakeLessThanTheRender(int width, int height) {
        for (double asked : new double[] {0.19, 0.09, 0.05, 0.03}) {
            RenderSettings settings = settings(width, height, RenderSettings.Budget.NONE.withError(asked));
            ErrorTrials trials = trials(settings, noise(0.2), () -> false);
            double n = trials.search(1, 2, MOST, 0);
            // Doubled samples in some of the pixels make less of a difference than as many more in each: up to 1.06
            // times.
            double error = 0.2 / Math.sqrt(n);
            assertTrue(error < asked && error > 0.5 * asked || n == 1, error + " for " + asked);
            assertTrue(trials.work() <= 0.75 * n, trials.work() + " for a render of " + n);
        }
    }

    /** The rounding that the file adds is known before the render. */
    @Test
    void roundingIsSeenAndPlannedFor() {
        RenderSettings plain = settings(320, 200, RenderSettings.Budget.NONE.withError(0.0016));
        double n = trials(plain, noise(0.004), () -> false).search(1, 2, MOST, 0);
        RenderSettings bits =
                settings(320, 200, RenderSettings.Budget.NONE.withError(0.0016).withDepth(8));
        ErrorTrials trials = trials(bits, noise(0.004), () -> false);
        double more = trials.search(1, 2, MOST, 0);
        assertEquals(1 / (255 * Math.sqrt(12)), trials.rounding(), 1e-4);
        double left = Math.sqrt(1 - Math.pow(trials.rounding() / 0.0016, 2));
        assertEquals(1 / (left * left), more / n, 0.5);
        RenderSettings few =
                settings(320, 200, RenderSettings.Budget.NONE.withError(0.001).withDepth(8));
        ErrorTrials hopeless = trials(few, noise(0.004), () -> false);
        assertEquals(Double.POSITIVE_INFINITY, hopeless.search(1, 2, MOST, 0));
        assertTrue(hopeless.isHopeless());
    }

    /** Where it is dear to plan for another number, few numbers are tried. */
    @Test
    void whatPlanningCostsCounts() {
        RenderSettings settings = settings(200, 100, RenderSettings.Budget.NONE.withError(0.05));
        for (double planning : new double[] {0.1, 0.5, 1.3, 3}) {
            ErrorTrials trials = trials(settings, noise(0.2), () -> false);
            double n = trials.search(2.45, 4, MOST, planning);
            assertTrue(n > 10 && n < 64, n + " where about 20 are enough");
            assertTrue(trials.work() <= 0.75 * n, trials.work() + " for a render of " + n);
        }
    }

    @Test
    void whatIsOutOfReachIsNotTriedForLong() {
        ErrorTrials trials =
                trials(settings(800, 400, RenderSettings.Budget.NONE.withError(0.01)), noise(0.2), () -> false);
        assertEquals(Double.POSITIVE_INFINITY, trials.search(1, 1, 2.44, 0));
        assertTrue(trials.work() <= 1.0 / 16 + 0.01);
    }

    /** Only blocks that are looked at again tell of something that the first ones missed. */
    @Test
    void aSecondPhaseIsLookedAtBeforeAnAnswer() {
        RenderSettings settings = settings(800, 400, RenderSettings.Budget.NONE.withError(0.01));
        List<FilmTile> first = new TrialBlocks(settings, DisplayCurve.NONE, FilmTile.BLOCK_SIDE).phase(0, 1.0 / 16);
        SplittableRandom random = new SplittableRandom(2);
        ErrorTrials trials = trials(
                settings,
                (n, blocks) -> blocks.forEach(block -> {
                    boolean isSeen = first.stream().anyMatch(f -> f.x == block.x && f.y == block.y);
                    fill(block, n, isSeen ? 0 : 0.2, random);
                }),
                () -> false);
        assertTrue(trials.search(1, 2, MOST, 0) > 50);
    }

    private static ErrorTrials trials(RenderSettings settings, ErrorTrials.Sampler sampler, BooleanSupplier stop) {
        return new ErrorTrials(
                settings, new TrialBlocks(settings, DisplayCurve.NONE, FilmTile.BLOCK_SIDE), sampler, stop, false);
    }
}

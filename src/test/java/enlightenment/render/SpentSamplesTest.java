package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.render.ManySeeds.Picture;
import enlightenment.scene.Budget;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code --samples N} spends N, with method cluster too. */
class SpentSamplesTest {
    /** Block by block the need is guessed from other samples than the picture's: this much is left to chance. */
    private static final double CHANCE = 0.07;

    /** Pixels across a block, and how many blocks are surveyed at most; four times as many from so many samples on. */
    private static final int SIDE = 8;

    private static final int BLOCKS = 512;
    private static final int MANY = 64;

    @TempDir
    Path directory;

    private static Picture render(Scene scene, RenderSettings settings, double samples) {
        return ManySeeds.render(
                scene, settings.withMethod(Method.CLUSTER).withBudget(Budget.NONE.withSamples(samples)));
    }

    private static double spent(Scene scene, RenderSettings settings, double samples) {
        return render(scene, settings, samples).sampling().samplesPerPixel() / samples;
    }

    /**
     * The relative standard error of a mean over all blocks that is judged by some of them: blocks differ, and where a scene
     * covers few of them, so does what a survey of a part meets.
     */
    private static double surveyError(Picture p, int width, int height, double samples) {
        double[] costs = new double[width / SIDE * (height / SIDE)];
        for (int k = 0; k < width * height; k++) {
            costs[k / width / SIDE * (width / SIDE) + k % width / SIDE] += p.counts()[k] / (double) (SIDE * SIDE);
        }
        double surveyed = samples < MANY ? BLOCKS : 4 * BLOCKS;
        double mean = Welch.mean(costs);
        double left = Math.max(0, 1 / surveyed - 1.0 / costs.length);
        return Math.sqrt(Welch.variance(costs, mean) * left) / p.sampling().samplesPerPixel();
    }

    private Scene scene(String name) {
        return FineScenes.NAMES.contains(name) ? FineScenes.of(name, directory) : ManySeeds.shipped(name);
    }

    @ParameterizedTest
    @CsvSource({"wires, 2.45", "wires, 16", "slats, 2.45", "keyhole, 16", "fire-and-ice, 2.45"})
    void whatIsAskedForIsSpent(String name, double samples) {
        Scene scene = scene(name);
        assertEquals(1, spent(scene, RenderSettings.of(scene).withSize(80, 60), samples), CHANCE);
    }

    /** Each pixel shows one slat and needs just what the others need: all would get twice as many samples at once. */
    @Test
    void whereAllPixelsNeedTheSameAnyNumberIsSpent() {
        Scene scene = FineScenes.of("comb", directory);
        for (double samples = 2.5; samples < 60; samples *= 1.7) {
            double spent = spent(scene, RenderSettings.of(scene).withSize(48, 36), samples);
            assertEquals(1, spent, CHANCE, samples + " samples");
        }
    }

    static Stream<Arguments> larger() {
        return Stream.concat(
                        FineScenes.NAMES.stream(),
                        Stream.of(
                                "fire-and-ice", "keyhole", "torus", "cylinders", "glass", "primitives", "cone", "cube"))
                .flatMap(name -> Stream.of(2.45, 4.0, 16.0, 64.0).map(n -> Arguments.of(name, n)));
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"slats, 16", "grid, 2.45", "grid, 16", "keyhole, 2.45", "fire-and-ice, 16"})
    void inMoreSmallPicturesToo(String name, double samples) {
        whatIsAskedForIsSpent(name, samples);
    }

    @ParameterizedTest
    @Tag("full")
    @MethodSource("larger")
    void norIsItMissedInLargerPicturesOfWhichPartIsSurveyed(String name, double samples) {
        Scene scene = scene(name);
        int width = FineScenes.NAMES.contains(name) ? 320 : 480;
        Picture p = render(scene, RenderSettings.of(scene).withSize(width, 240), samples);
        // Three standard errors: of 40 cases in which not all is surveyed, one fails with a probability of 10 % at
        // most.
        double allowed = CHANCE + 3 * surveyError(p, width, 240, samples);
        assertEquals(1, p.sampling().samplesPerPixel() / samples, allowed);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"wires", "slats", "keyhole", "fire-and-ice"})
    void aThousandSamplesAreSpentToo(String name) {
        Scene scene = scene(name);
        assertEquals(1, spent(scene, RenderSettings.of(scene).withSize(64, 48), 1000), CHANCE);
    }
}

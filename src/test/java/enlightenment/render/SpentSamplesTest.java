package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code --samples N} spends N, with method cluster too. */
class SpentSamplesTest {
    /** Block by block the need is guessed from other samples than the picture's: this much is left to chance. */
    private static final double CHANCE = 0.07;

    @TempDir
    Path directory;

    private static double spent(Scene scene, RenderSettings settings, double samples) {
        RenderSettings s = settings.withMethod(Method.CLUSTER).withBudget(Budget.NONE.withSamples(samples));
        return ManySeeds.render(scene, s).sampling().samplesPerPixel() / samples;
    }

    static Stream<Arguments> pictures() {
        return Stream.of("wires", "slats", "grid", "keyhole", "fire-and-ice")
                .flatMap(name -> Stream.of(2.45, 16.0).map(n -> Arguments.of(name, n)));
    }

    private Scene scene(String name) {
        return FineScenes.NAMES.contains(name) ? FineScenes.of(name, directory) : ManySeeds.shipped(name);
    }

    @ParameterizedTest
    @MethodSource("pictures")
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
                .flatMap(name -> Stream.of(2.45, 4.0, 16.0, 100.0).map(n -> Arguments.of(name, n)));
    }

    @ParameterizedTest
    @Tag("full")
    @MethodSource("larger")
    void norIsItMissedInLargerPicturesOfWhichPartIsSurveyed(String name, double samples) {
        Scene scene = scene(name);
        boolean fine = FineScenes.NAMES.contains(name);
        double spent = spent(scene, RenderSettings.of(scene).withSize(fine ? 320 : 480, 240), samples);
        System.out.println(name + ", " + samples + " samples: " + spent);
        assertEquals(1, spent, CHANCE);
    }

    @ParameterizedTest
    @Tag("full")
    @ValueSource(strings = {"wires", "slats", "keyhole", "fire-and-ice"})
    void aThousandSamplesAreSpentToo(String name) {
        Scene scene = scene(name);
        double spent = spent(scene, RenderSettings.of(scene).withSize(64, 48), 1000);
        System.out.println(name + ", 1000 samples: " + spent);
        assertTrue(Math.abs(spent - 1) < CHANCE, name + ": " + spent);
    }
}

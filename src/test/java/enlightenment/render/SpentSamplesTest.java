package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.ManySeeds.Picture;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.Locale;
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

    /** Pixels across a block, and how many blocks are surveyed at most. */
    private static final int SIDE = 8;

    private static final int BLOCKS = 512;

    @TempDir
    Path directory;

    private static Picture render(Scene scene, RenderSettings settings, double samples) {
        return ManySeeds.render(
                scene, settings.withMethod(Method.CLUSTER).withBudget(RenderSettings.Budget.NONE.withSamples(samples)));
    }

    private static double spent(Scene scene, RenderSettings settings, double samples) {
        RenderSettings asked =
                settings.withMethod(Method.CLUSTER).withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        return ManySeeds.sampling(scene, asked).samplesPerPixel() / samples;
    }

    /**
     * The relative standard error of a mean over all blocks that is judged by some of them: blocks differ, and where a scene
     * covers few of them, so does what a survey of a part meets.
     */
    private static double surveyError(Picture p, int width, int height) {
        double[] costs = new double[width / SIDE * (height / SIDE)];
        for (int k = 0; k < width * height; k++) {
            costs[k / width / SIDE * (width / SIDE) + k % width / SIDE] += p.counts()[k] / (double) (SIDE * SIDE);
        }
        double mean = Welch.mean(costs);
        double left = Math.max(0, 1.0 / BLOCKS - 1.0 / costs.length);
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

    private static Scene parse(String json, String name) {
        return SceneReader.readString(json, Path.of("."), name);
    }

    /** A floor under water: light comes through its surface by rare paths only, of which the first ones show few or none. */
    private static Scene underWater() {
        return parse(
                """
                {
                  "image": { "width": 16, "height": 12 },
                  "camera": { "type": "perspective", "eye": [0.9, 1.3, -4], "lookAt": [0, -0.5, 0], "fieldOfView": 30 },
                  "shading": { "model": "physical", "background": { "linear": [0, 0, 0] }, "maxBounces": 3 },
                  "objects": [
                    { "type": "rectangle", "corners": [[-3, -1, -3], [-3, -1, 3], [3, -1, 3], [3, -1, -3]],
                      "material": { "type": "matte", "color": { "linear": [0.8, 0.8, 0.8] } } },
                    { "type": "rectangle", "corners": [[-1.5, 1.5, -1.1], [-1.2, 1.1, -1.1], [-1.3, 1.1, -0.9], [-1.6, 1.5, -0.9]],
                      "material": { "type": "matte", "color": { "linear": [0.5, 0.5, 0.5] }, "radiance": 20 } },
                    { "type": "box", "min": [-2.5, -1.2, -2.5], "max": [2.5, 0.8, 2.5],
                      "material": { "type": "glass", "color": { "linear": [1, 1, 1] }, "indexOfRefraction": 1.33 } }
                  ]
                }
                """,
                "water");
    }

    /** What is seen first is of one block, and what the picture's own paths find there is left to chance: the sum is not. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void rareBrightPathsDoNotMultiplyWhatIsSpentOnASmallPicture(long seed) {
        Scene scene = underWater();
        RenderSettings settings = RenderSettings.of(scene).withSize(16, 12).withSeed(seed);
        assertEquals(1, spent(scene, settings, 16), CHANCE);
    }

    /** Of more blocks, all of which are tried, some find what they did not when they were tried. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void norOnOneOfSomeBlocks(long seed) {
        Scene scene = underWater();
        RenderSettings settings = RenderSettings.of(scene).withSize(64, 48).withSeed(seed);
        double spent = spent(scene, settings, 16);
        assertTrue(spent > 0.67 && spent < 1.5, spent + " of what was asked for");
    }

    /** Two balls of a few pixels on empty ground: no block of those that are tried need show them if these are spread evenly. */
    private static Scene twoBalls(String shading, String radiance, double x, double y) {
        return parse(
                String.format(
                        Locale.ROOT,
                        """
                        {
                          "image": { "width": 512, "height": 512 },
                          "camera": { "type": "orthographic", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "height": 10 },
                          "shading": { %s },
                          "lights": [ { "type": "sphere", "center": [%f, %f, -2], "radius": 0.3, "color": "#ffffff" %s } ],
                          "objects": [
                            { "type": "sphere", "center": [%f, %f, 0], "radius": 0.12,
                              "material": { "type": "matte", "color": "#808080" } },
                            { "type": "sphere", "center": [%f, %f, -0.12], "radius": 0.06,
                              "material": { "type": "matte", "color": "#808080" } }
                          ]
                        }
                        """,
                        shading,
                        x + 2,
                        y + 3,
                        radiance,
                        x,
                        y,
                        x + 0.084,
                        y + 0.06),
                "two balls");
    }

    @ParameterizedTest
    @CsvSource({"1.1, 1.3", "-2.3, 0.7", "3.1, -3.7", "-4, -1.9"})
    void whatIsAskedForIsSpentOnASmallThingOnEmptyGround(double x, double y) {
        Scene physical = twoBalls("\"model\": \"physical\"", ", \"radiance\": 20", x, y);
        assertEquals(1, spent(physical, RenderSettings.of(physical).withSize(256, 256), 8), CHANCE);
    }

    @ParameterizedTest
    @CsvSource({"1.1, 1.3", "-2.3, 0.7", "3.1, -3.7", "-4, -1.9"})
    void norIsItMissedThereInClassicShading(double x, double y) {
        Scene classic = twoBalls("", "", x, y);
        assertEquals(1, spent(classic, RenderSettings.of(classic).withSize(512, 512), 8), CHANCE);
    }

    /** Balls of six tenths of a pixel in a row, a hundred pixels apart, in the middle of a picture of 1000 by {@code height} pixels. */
    private static Scene dust(int count, int height) {
        StringBuilder balls = new StringBuilder();
        for (int k = 0; k < count; k++) {
            balls.append(k == 0 ? "" : ",")
                    .append(String.format(
                            Locale.ROOT,
                            "{ \"type\": \"sphere\", \"center\": [%d, 0, 0], \"radius\": 0.3,"
                                    + " \"material\": { \"type\": \"matte\", \"color\": \"#cccccc\" } }",
                            100 * (k - count / 2)));
        }
        return parse(
                String.format(
                        """
                        {
                          "image": { "width": 1000, "height": %1$d },
                          "camera": { "type": "orthographic", "eye": [0, 0, -4], "lookAt": [0, 0, 0], "height": %1$d },
                          "lights": [ { "type": "sphere", "center": [-1.6, 2.7, -0.3], "radius": 0.01, "color": "#ffffff" } ],
                          "objects": [ %2$s ]
                        }
                        """,
                        height, balls),
                "dust");
    }

    /** What chance decides, whether first samples met the ball, is not what is spent: neither 0.02 of it nor 33 times as much. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void whatIsAskedForIsSpentInAnOnlyBlockWhateverItsFirstSamplesMeet(long seed) {
        Scene scene = dust(1, 3);
        assertEquals(1, spent(scene, RenderSettings.of(scene).withSeed(seed), 64), CHANCE);
    }

    /** Seven balls, of which some are met by first samples and some are not. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void soItIsInAFewBlocks(long seed) {
        Scene scene = dust(7, 3);
        assertEquals(1, spent(scene, RenderSettings.of(scene).withSeed(seed), 16), CHANCE);
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
        double allowed = CHANCE + 3 * surveyError(p, width, 240);
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

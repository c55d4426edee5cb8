package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.image.Image;
import enlightenment.method.cluster.PhysicalClusterMethod;
import enlightenment.render.BlockMeans.Verdict;
import enlightenment.sampling.RunningStatistics;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the cluster method makes of physical light. */
class PhysicalClusterTest {
    private static final int WIDTH = 48;
    private static final int HEIGHT = 24;

    /** The methods have their random numbers in common. */
    private static final long APART = 1000;

    private static RenderSettings settings(Scene scene, Method method, double samples) {
        return RenderSettings.of(scene)
                .withMethod(method)
                .withSize(WIDTH, HEIGHT)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
    }

    private static Image image(Scene scene, RenderSettings settings) {
        return Renderer.render(scene, settings);
    }

    /** Pictures with the seeds first, first + 1, … */
    static List<double[]> pictures(Scene scene, RenderSettings settings, long first, int count) {
        List<double[]> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            float[] rgb = image(scene, settings.withSeed(first + k)).toArray();
            double[] values = new double[rgb.length];
            for (int i = 0; i < rgb.length; i++) {
                values[i] = rgb[i];
            }
            all.add(values);
        }
        return all;
    }

    private static void compare(String name, double samples, int seeds) {
        compare(name, ManySeeds.shipped(name), samples, seeds);
    }

    private static void compare(String name, Scene scene, double samples, int seeds) {
        List<double[]> clustered = pictures(scene, settings(scene, Method.CLUSTER, samples), 1, seeds);
        List<double[]> traced = pictures(scene, settings(scene, Method.RAYTRACE, samples), APART, seeds);
        Verdict verdict = new BlockMeans(WIDTH, HEIGHT).compare(clustered, traced);
        assertFalse(verdict.isDifferent(), name + ": " + verdict);
    }

    /** By Welch's test for each block and the whole, at 1 % for all together. */
    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice-physical", "cornell-box", "glass-physical"})
    void itMeansThePictureOfRaytrace(String name) {
        compare(name, 9, 24);
    }

    /** A room in which a box and a turned cube stand on the floor, so that faces coincide. */
    private static final String FURNISHED =
            """
            {
              "image": { "width": 48, "height": 24 },
              "camera": { "type": "perspective", "eye": [0, 1, -3], "lookAt": [0, 0.7, 0], "fieldOfView": 32 },
              "shading": { "model": "physical" },
              "materials": {
                "white": { "type": "matte", "color": { "linear": [0.7, 0.7, 0.7] } },
                "red": { "type": "matte", "color": { "linear": [0.6, 0.1, 0.1] } }
              },
              "lights": [ { "type": "rectangle", "radiance": 12, "color": "#ffffff", "twoSided": false,
                "corners": [[-0.3, 1.99, 0.3], [-0.3, 1.99, -0.3], [0.3, 1.99, -0.3], [0.3, 1.99, 0.3]] } ],
              "objects": [
                { "type": "rectangle", "corners": [[-2, 0, -1], [-2, 0, 1], [2, 0, 1], [2, 0, -1]], "material": "white" },
                { "type": "rectangle", "corners": [[-2, 2, -1], [-2, 2, 1], [2, 2, 1], [2, 2, -1]], "material": "white" },
                { "type": "rectangle", "corners": [[-2, 0, 1], [-2, 2, 1], [2, 2, 1], [2, 0, 1]], "material": "white" },
                { "type": "rectangle", "corners": [[-2, 0, -1], [-2, 2, -1], [-2, 2, 1], [-2, 0, 1]], "material": "red" },
                { "type": "rectangle", "corners": [[2, 0, -1], [2, 2, -1], [2, 2, 1], [2, 0, 1]], "material": "white" },
                { "type": "box", "min": [-1.2, 0, 0], "max": [-0.5, 1.2, 0.5], "material": "white" },
                { "type": "cube", "center": [0.8, 0.3, -0.2], "radius": 0.5196152422706631, "rotation": [0, 20, 0], "material": "red" }
              ]
            }
            """;

    private static Scene furnished() {
        return SceneReader.readString(FURNISHED, Path.of("."), "furnished");
    }

    @Test
    void roomsWithFurnitureHaveTheSameMean() {
        compare("furnished", furnished(), 9, 24);
    }

    /** Thirty-two paths in place of one, but for edges and for direct light in penumbras. */
    @Test
    void wherePathsAreSharedTheyVaryLess() {
        Scene scene = furnished();
        double shared = variance(pictures(scene, settings(scene, Method.CLUSTER, 16), 1, 8));
        double alone = variance(pictures(scene, settings(scene, Method.RAYTRACE, 16), 1, 8));
        assertTrue(shared < alone / 4, shared + " of " + alone);
    }

    /** The mean over all values of their variance among some pictures. */
    private static double variance(List<double[]> pictures) {
        int values = pictures.get(0).length;
        double sum = 0;
        for (int k = 0; k < values; k++) {
            RunningStatistics of = new RunningStatistics();
            for (double[] picture : pictures) {
                of.add(picture[k]);
            }
            sum += of.variance();
        }
        return sum / values;
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "fire-and-ice-physical",
                "cornell-box",
                "metals",
                "lamp-room",
                "door-ajar",
                "glass-physical",
                "furnace"
            })
    void itMeansThePictureOfRaytraceWithManySeeds(String name) {
        compare(name, 16, 128);
    }

    @ParameterizedTest
    @ValueSource(strings = {"fire-and-ice-physical", "lamp-room"})
    void threadsTilesAndCropsChangeNoBit(String name) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings settings = settings(scene, Method.CLUSTER, 9.7).withThreads(1);
        float[] whole = image(scene, settings).toArray();
        assertArrayEquals(
                whole, image(scene, settings.withThreads(3).withTileSize(5)).toArray(), "three threads and tiles of 5");
        Crop crop = new Crop(19, 5, 23, 17);
        float[] part = image(scene, settings.withCrop(crop)).toArray();
        for (int k = 0; k < part.length; k++) {
            int x = crop.x() + k / 3 % crop.width();
            int y = crop.y() + k / 3 / crop.width();
            assertEquals(whole[3 * (y * WIDTH + x) + k % 3], part[k], "pixel " + x + ", " + y);
        }
    }

    @Test
    void withTooFewSamplesForASurveyItIsRaytraceToTheBit() {
        Scene scene = ManySeeds.shipped("fire-and-ice-physical");
        assertArrayEquals(
                image(scene, settings(scene, Method.RAYTRACE, 2)).toArray(),
                image(scene, settings(scene, Method.CLUSTER, 2)).toArray());
    }

    /** Two matte walls that light each other, one of them under a lamp so bright that it shows white whatever a path finds. */
    private static Scene burntOut(double exposure) {
        return SceneReader.readString(
                """
                {
                  "image": { "width": 48, "height": 24 },
                  "camera": { "type": "perspective", "eye": [0, 1, -6], "lookAt": [0, 1, 0], "fieldOfView": 40 },
                  "shading": { "model": "physical" },
                  "display": { "exposure": EXPOSURE },
                  "materials": { "white": { "type": "matte", "color": { "linear": [0.7, 0.7, 0.7] } } },
                  "lights": [ { "type": "sphere", "center": [-2, 1, -1], "radius": 0.2, "color": "#ffffff", "radiance": 200 } ],
                  "objects": [
                    { "type": "rectangle", "corners": [[-9, -9, 1], [-9, 9, 1], [9, 9, 1], [9, -9, 1]], "material": "white" },
                    { "type": "rectangle", "corners": [[-9, -1, -9], [-9, -1, 9], [9, -1, 9], [9, -1, -9]], "material": "white" }
                  ]
                }
                """
                        .replace("EXPOSURE", Double.toString(exposure)),
                Path.of("."),
                "burnt out");
    }

    private static FilmTile tile(Scene scene, double effort, double samples) {
        RenderSettings settings = settings(scene, Method.CLUSTER, samples);
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        FilmTile tile = new FilmTile(0, 0, WIDTH, HEIGHT, compiled.display);
        new PhysicalClusterMethod(
                        compiled, settings, new RayCounters(compiled.kindNames.size()), effort, samples, false)
                .render(tile);
        return tile;
    }

    /** The same light, displayed four times as bright: where that is white samples are worth nothing any more. */
    @Test
    void whatIsBurntOutGetsTheLeastOfAll() {
        Scene scene = burntOut(12);
        FilmTile tile = tile(scene, 1e9, 16);
        int white = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                // A block of which a part is not white may need more.
                if (allWhite(tile, x / 8 * 8, y / 8 * 8)) {
                    white++;
                    assertEquals(8, tile.count(x, y), "pixel " + x + ", " + y);
                }
            }
        }
        assertTrue(white >= WIDTH * HEIGHT / 4, white + " pixels");
    }

    private static boolean allWhite(FilmTile tile, int left, int top) {
        for (int y = top; y < top + 8; y++) {
            for (int x = left; x < left + 8; x++) {
                for (int c = 0; c < 3; c++) {
                    if (tile.mean(x, y, c) * 4096 < 64) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** Where paths vary, and the screen shows it, there are more samples than the least. */
    @Test
    void samplesAreWhereTheScreenShowsNoise() {
        FilmTile tile = tile(burntOut(0), 1e6, 16);
        int[] counts = new int[WIDTH * HEIGHT];
        for (int k = 0; k < counts.length; k++) {
            counts[k] = tile.count(k % WIDTH, k / WIDTH);
        }
        assertTrue(Arrays.stream(counts).max().orElseThrow() > 8);
        assertTrue(Arrays.stream(counts).allMatch(n -> Integer.bitCount(n) == 1 && n >= 8));
    }

    /** A ball at the left, and the sky. */
    private static final String SKY =
            """
            {
              "image": { "width": 48, "height": 24 },
              "camera": { "type": "perspective", "eye": [0, 0, -6], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical", "background": { "linear": [0.25, 0.5, 1] } },
              "lights": [ { "type": "sphere", "center": [-2, 3, -1], "radius": 0.2, "color": "#ffffff", "radiance": 200 } ],
              "objects": [ { "type": "sphere", "center": [-2, 0, 0], "radius": 1,
                "material": { "type": "matte", "color": { "linear": [0.7, 0.7, 0.7] } } } ]
            }
            """;

    /** Whatever was seen in the block before. */
    @Test
    void whereNothingIsSeenTheLeastSamplesShowTheBackground() {
        FilmTile tile = tile(SceneReader.readString(SKY, Path.of("."), "sky"), 1e7, 16);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = WIDTH / 2; x < WIDTH; x++) {
                assertEquals(8, tile.count(x, y), "pixel " + x + ", " + y);
                assertEquals(0.25, tile.mean(x, y, 0), 1e-6);
                assertEquals(1, tile.mean(x, y, 2), 1e-6);
            }
        }
    }

    @Test
    void whatIsSpentIsAboutWhatIsAskedFor() {
        Scene scene = ManySeeds.shipped("fire-and-ice-physical");
        RenderSettings settings = settings(scene, Method.CLUSTER, 24).withSize(128, 64);
        RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        assertEquals(24, result.report().sampling().samplesPerPixel(), 2.4);
        assertEquals(Method.CLUSTER, result.report().sampling().method());
    }

    /** Of many pictures with an error to keep, as good as all keep it. */
    @Test
    void anErrorThatIsAskedForIsReportedAsKept() {
        Scene scene = ManySeeds.shipped("fire-and-ice-physical");
        RenderSettings settings = settings(scene, Method.CLUSTER, 64)
                .withBudget(RenderSettings.Budget.NONE.withError(0.03).withSamples(256));
        RenderResult result = Renderer.render(scene, settings, RenderProgress.NONE, () -> false);
        assertTrue(result.report().sampling().errorHigh() <= 0.03);
    }
}

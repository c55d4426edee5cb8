package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.classic.cluster.ClusterCost;
import enlightenment.classic.cluster.ClusterMethod;
import enlightenment.film.FilmTile;
import enlightenment.render.ManySeeds.Picture;
import enlightenment.sampling.Distribution;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How the work is done changes no bit of what the cluster method makes, with or without a budget. */
class ClusterInvarianceTest {
    private static final int WIDTH = 60;
    private static final int HEIGHT = 30;

    private static final int[][] WAYS = {{2, 64}, {7, 5}};
    private static final int[][] MORE_WAYS = {{2, 8}, {7, 8}, {2, 64}, {7, 5}};
    private static final List<Crop> CROPS = List.of(new Crop(19, 5, 23, 17), new Crop(59, 29, 1, 1));
    private static final List<Crop> MORE_CROPS =
            List.of(new Crop(0, 0, 8, 8), new Crop(19, 5, 23, 17), new Crop(59, 29, 1, 1));

    /** No budget, and each kind of budget. */
    static Stream<Arguments> pictures() {
        return Stream.of(
                Arguments.of("keyhole", RenderSettings.Budget.NONE),
                Arguments.of("keyhole", RenderSettings.Budget.NONE.withSamples(9.7)),
                Arguments.of(
                        "keyhole", RenderSettings.Budget.NONE.withError(0.001).withSamples(30)),
                Arguments.of("fire-and-ice", RenderSettings.Budget.NONE.withSamples(9.7)),
                Arguments.of("fire-and-ice", RenderSettings.Budget.NONE.withSamples(70)),
                Arguments.of("fire-and-ice", RenderSettings.Budget.NONE.withError(0.02)));
    }

    static Stream<Arguments> morePictures() {
        return Stream.of("keyhole", "fire-and-ice").flatMap(name -> Stream.of(
                        RenderSettings.Budget.NONE,
                        RenderSettings.Budget.NONE.withSamples(9.7),
                        RenderSettings.Budget.NONE.withError(0.02),
                        RenderSettings.Budget.NONE.withError(0.001).withSamples(30))
                .map(budget -> Arguments.of(name, budget)));
    }

    private static RenderSettings settings(Scene scene, RenderSettings.Budget budget) {
        return RenderSettings.of(scene)
                .withMethod(Method.CLUSTER)
                .withSize(WIDTH, HEIGHT)
                .withBudget(budget)
                .withThreads(1);
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void threadsAndTilesChangeNoBit(String name, RenderSettings.Budget budget) {
        compareWays(name, budget, WAYS);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("morePictures")
    void threadsAndTilesChangeNoBitOfMorePictures(String name, RenderSettings.Budget budget) {
        compareWays(name, budget, MORE_WAYS);
    }

    private static void compareWays(String name, RenderSettings.Budget budget, int[][] ways) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings settings = settings(scene, budget);
        Picture one = ManySeeds.render(scene, settings);
        // With an error to keep, the first round of so small a picture is the trial: one sample per pixel, no clusters.
        if (name.equals("keyhole")
                && budget.samples().isPresent()
                && budget.error().isEmpty()) {
            assertTrue(one.sampling().clusters() > 0, "no light points were proposed");
        }
        for (int[] way : ways) {
            Picture other = ManySeeds.render(scene, settings.withThreads(way[0]).withTileSize(way[1]));
            String what = way[0] + " threads, tiles of " + way[1];
            assertEquals(one.plan(), other.plan(), what);
            assertArrayEquals(one.rgb(), other.rgb(), what);
            assertArrayEquals(one.counts(), other.counts(), what);
        }
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void aCropShowsThePixelsOfTheWhole(String name, RenderSettings.Budget budget) {
        compareCrops(name, budget, CROPS);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("morePictures")
    void moreCropsShowThePixelsOfTheWhole(String name, RenderSettings.Budget budget) {
        compareCrops(name, budget, MORE_CROPS);
    }

    private static void compareCrops(String name, RenderSettings.Budget budget, List<Crop> crops) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings settings = settings(scene, budget);
        Picture whole = ManySeeds.render(scene, settings);
        for (Crop crop : crops) {
            Picture part = ManySeeds.render(scene, settings.withCrop(crop));
            for (int k = 0; k < part.rgb().length; k++) {
                int x = crop.x() + k / 3 % crop.width();
                int y = crop.y() + k / 3 / crop.width();
                assertEquals(
                        whole.film().component(x, y, k % 3),
                        part.rgb()[k],
                        "column " + x + ", row " + y + " of " + crop);
                assertEquals(whole.film().count(x, y), part.counts()[k / 3]);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("pictures")
    void theEstimatedErrorIsThatOfThePictureAndNotOfItsTiles(String name, RenderSettings.Budget budget) {
        compareErrors(name, budget);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("morePictures")
    void theEstimatedErrorIsThatOfThePictureWhateverTheBudget(String name, RenderSettings.Budget budget) {
        compareErrors(name, budget);
    }

    private static void compareErrors(String name, RenderSettings.Budget budget) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings settings = settings(scene, budget);
        double standard = ManySeeds.render(scene, settings).sampling().estimatedError();
        double large =
                ManySeeds.render(scene, settings.withTileSize(64)).sampling().estimatedError();
        // Single samples are compared with neighbours in the same tile, of which larger tiles have a few more.
        assertEquals(standard, large, 0.02 * standard);
    }

    /** Blocks at the border have fewer pixels than others: nothing of the block before may count as theirs. */
    @ParameterizedTest
    @ValueSource(strings = {"glass", "keyhole", "primitives"})
    void aBlockDoesNotDependOnWhatWasRenderedBefore(String name) {
        Scene scene = ManySeeds.shipped(name);
        RenderSettings settings = settings(scene, RenderSettings.Budget.NONE);
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        for (double samples : new double[] {2.6, 10.6}) {
            double effort = ClusterCost.of(compiled, settings, 32).effort(samples);
            ClusterMethod used = method(compiled, settings, effort, samples);
            for (int y = 0; y < HEIGHT; y += 8) {
                for (int x = 0; x < WIDTH; x += 8) {
                    FilmTile again = new FilmTile(x, y, Math.min(8, WIDTH - x), Math.min(8, HEIGHT - y));
                    FilmTile first = new FilmTile(x, y, again.width, again.height);
                    used.render(again);
                    method(compiled, settings, effort, samples).render(first);
                    assertSame(first, again);
                }
            }
        }
    }

    private static ClusterMethod method(CompiledScene scene, RenderSettings settings, double effort, double samples) {
        RayCounters counters = new RayCounters(scene.kindNames.size());
        return new ClusterMethod(
                scene,
                settings,
                counters,
                Distribution.of(BuiltInMethod.ClusterSettings.of(settings).proposal()),
                effort,
                samples);
    }

    private static void assertSame(FilmTile first, FilmTile again) {
        for (int y = first.y; y < first.y + first.height; y++) {
            for (int x = first.x; x < first.x + first.width; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(first.mean(x, y, c), again.mean(x, y, c), "column " + x + ", row " + y);
                }
            }
        }
    }
}

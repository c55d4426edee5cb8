package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.render.BlockMeans.Verdict;
import enlightenment.sampling.RunningStatistics;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.RenderSettings.Crop;
import enlightenment.scene.Scene;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures whose pixels share paths over blocks of 32 × 32 and 64 × 64. */
class LargeClusterPicturesTest {
    private static final Scene ROOM = ManySeeds.shipped("cornell-box");

    /** The methods have their random numbers in common. */
    private static final long APART = 1000;

    /** Of a block of 64 pixels, and of two of 32. */
    private static final Crop CROP = new Crop(640, 576, 64, 32);

    private static RenderSettings settings(Method method, int height) {
        return RenderSettings.of(ROOM)
                .withMethod(method)
                .withSize(2 * height, height)
                .withCrop(CROP)
                .withThreads(2)
                .withBudget(RenderSettings.Budget.NONE.withSamples(8));
    }

    private static List<double[]> pictures(Method method, int height, long first, int count) {
        return PhysicalClusterTest.pictures(ROOM, settings(method, height), first, count);
    }

    private static void compare(int height, int seeds) {
        List<double[]> clustered = pictures(Method.CLUSTER, height, 1, seeds);
        List<double[]> traced = pictures(Method.RAYTRACE, height, APART, seeds);
        Verdict verdict = new BlockMeans(CROP.width(), CROP.height()).compare(clustered, traced);
        assertFalse(verdict.isDifferent(), height + " rows: " + verdict);
    }

    @Test
    void theyHaveTheMeanOfRaytrace() {
        compare(640, 12);
    }

    @Tag("full")
    @ParameterizedTest
    @ValueSource(ints = {640, 1280})
    void theyHaveTheMeanOfRaytraceWithManySeeds(int height) {
        compare(height, 64);
    }

    @ParameterizedTest
    @EnumSource(
            value = BuiltInMethod.class,
            names = {"CLUSTER", "BIDIRECTIONAL_CLUSTER"})
    void threadsTilesAndCropsChangeNoBit(BuiltInMethod method) {
        RenderSettings settings = settings(method, 640).withThreads(1);
        float[] whole = Renderer.render(ROOM, settings).toArray();
        Crop crop = new Crop(660, 580, 25, 17);
        float[] part = Renderer.render(
                        ROOM, settings.withCrop(crop).withThreads(3).withTileSize(5))
                .toArray();
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < 3 * crop.width(); x++) {
                int inWhole = 3 * ((crop.y() - CROP.y() + y) * CROP.width() + crop.x() - CROP.x()) + x;
                assertEquals(whole[inWhole], part[3 * crop.width() * y + x]);
            }
        }
        assertArrayEquals(
                whole, Renderer.render(ROOM, settings.withTileSize(64)).toArray());
    }

    /**
     * The mean of a square of 16 × 16 has as much variance as with paths that share nothing if all of those that its pixels share are its
     * own; a quarter if they are those of 32 × 32.
     */
    @Test
    void meansOfSquaresVaryLess() {
        double shared = varianceOfSquares(pictures(Method.CLUSTER, 640, 1, 8));
        double alone = varianceOfSquares(pictures(Method.RAYTRACE, 640, APART, 8));
        assertTrue(shared < alone / 2, shared + " of " + alone);
    }

    /** The mean over all squares of 16 × 16 pixels of the variance of their mean. */
    private static double varianceOfSquares(List<double[]> pictures) {
        BlockMeans means = new BlockMeans(CROP.width(), CROP.height());
        double sum = 0;
        int squares = 0;
        for (int y = 0; y < CROP.height(); y += 16) {
            for (int x = 0; x < CROP.width(); x += 16) {
                RunningStatistics of = new RunningStatistics();
                for (double mean : means.means(pictures, x, y, x + 16, y + 16)) {
                    of.add(mean);
                }
                sum += of.variance();
                squares++;
            }
        }
        return sum / squares;
    }
}

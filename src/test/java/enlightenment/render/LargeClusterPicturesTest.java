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
import java.util.ArrayList;
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

    private static List<double[]> pictures(RenderSettings settings, long first, int count) {
        List<double[]> all = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            float[] rgb = Renderer.render(ROOM, settings.withSeed(first + k)).toArray();
            double[] values = new double[rgb.length];
            for (int i = 0; i < rgb.length; i++) {
                values[i] = rgb[i];
            }
            all.add(values);
        }
        return all;
    }

    private static void compare(int height, int seeds) {
        List<double[]> clustered = pictures(settings(Method.CLUSTER, height), 1, seeds);
        List<double[]> traced = pictures(settings(Method.RAYTRACE, height), APART, seeds);
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
        double shared = varianceOfSquares(pictures(settings(Method.CLUSTER, 640), 1, 8));
        double alone = varianceOfSquares(pictures(settings(Method.RAYTRACE, 640), APART, 8));
        assertTrue(shared < alone / 2, shared + " of " + alone);
    }

    /** The mean over all squares of 16 × 16 pixels of the variance of their mean. */
    private static double varianceOfSquares(List<double[]> pictures) {
        double sum = 0;
        int squares = 0;
        for (int y = 0; y < CROP.height(); y += 16) {
            for (int x = 0; x < CROP.width(); x += 16) {
                RunningStatistics of = new RunningStatistics();
                for (double[] picture : pictures) {
                    of.add(meanOfSquare(picture, x, y));
                }
                sum += of.variance();
                squares++;
            }
        }
        return sum / squares;
    }

    private static double meanOfSquare(double[] picture, int left, int top) {
        double sum = 0;
        for (int y = top; y < top + 16; y++) {
            for (int k = 3 * left; k < 3 * (left + 16); k++) {
                sum += picture[3 * CROP.width() * y + k];
            }
        }
        return sum / (3 * 16 * 16);
    }
}

package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.scene.BuiltInMethod;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Variance, missed light and cost of methods, from pictures whose statistics are known. */
class PilotScoresTest {
    private static final int SIDE = 64;
    private static final int SAMPLES = 4;

    private static PilotPicture picture(double[] light) {
        RayCounters counts = new RayCounters(1);
        counts.cameraRays = (long) SAMPLES * SIDE * SIDE;
        counts.hits[0] = 2 * counts.cameraRays;
        return new PilotPicture(light, new double[0], counts);
    }

    /** Pixels of mean 1 with normal noise. */
    private static List<PilotPicture> noisy(double deviation, long seed) {
        Random random = new Random(seed);
        return Arrays.asList(new PilotPicture[2]).stream()
                .map(unused -> {
                    double[] light = new double[3 * SIDE * SIDE];
                    Arrays.setAll(light, i -> 1 + deviation * random.nextGaussian());
                    return picture(light);
                })
                .toList();
    }

    private static PilotScores scores(List<PilotPicture> ray, List<PilotPicture> guard) {
        Map<BuiltInMethod, List<PilotPicture>> pictures = new EnumMap<>(BuiltInMethod.class);
        pictures.put(BuiltInMethod.RAYTRACE, ray);
        pictures.put(BuiltInMethod.BIDIRECTIONAL, guard);
        return new PilotScores(SIDE, SIDE, SAMPLES, pictures, BuiltInMethod.BIDIRECTIONAL);
    }

    @Test
    void theVarianceOfASampleIsThatOfThePicturesTimesTheirSamples() {
        double deviation = 0.02;
        PilotScore score = scores(noisy(deviation, 1), noisy(0.01, 2)).of(BuiltInMethod.RAYTRACE);
        double expected = SAMPLES * deviation * deviation / (1 + 0.05 * 0.05);
        // 12288 squares of one degree of freedom: a standard deviation of 1.3 %, of which 6 %.
        assertEquals(expected, score.variance(), 0.06 * expected);
        // Of 4096 pixels of 3 bands each.
        assertEquals(expected * Math.sqrt(2.0 / (3 * SIDE * SIDE)), score.uncertain(), 0.2 * score.uncertain());
    }

    /** Of 1 path in 200, which is 200 times as bright: the variance is 199. No square of a pixel's own mean of four is more than 4 times it. */
    @Test
    void noiseDoesNotHideItself() {
        Random random = new Random(5);
        List<PilotPicture> rare = Arrays.asList(new PilotPicture[4]).stream()
                .map(unused -> {
                    double[] light = new double[3 * SIDE * SIDE];
                    Arrays.setAll(light, i -> random.nextInt(200) == 0 ? 200 : 0);
                    return picture(light);
                })
                .toList();
        PilotScore score = scores(rare.subList(0, 2), rare.subList(2, 4)).of(BuiltInMethod.RAYTRACE);
        double expected = SAMPLES * 199 / (1 + 0.05 * 0.05);
        // Some 120 such paths: a standard deviation of 9 %, of which 4, and as much of the square of the mean.
        assertEquals(expected, score.variance(), 0.4 * expected);
    }

    @Test
    void lightThatOnlyTheGuardFoundCountsAsTheSecondMomentOfPathsThatWereNotFound() {
        // All light of one block is missing.
        double[] there = new double[3 * SIDE * SIDE];
        Arrays.fill(there, 1);
        double[] missing = there.clone();
        for (int y = 0; y < 4; y++) {
            for (int x = 0; x < 4; x++) {
                Arrays.fill(missing, 3 * (y * SIDE + x), 3 * (y * SIDE + x) + 3, 0);
            }
        }
        List<PilotPicture> guard = List.of(picture(there), picture(there));
        PilotScores scores = scores(List.of(picture(missing), picture(missing)), guard);
        assertEquals(0, scores.of(BuiltInMethod.BIDIRECTIONAL).missed());
        // 1 squared times 16 pixels with 4 samples in 2 pictures, in one of 256 blocks whose mean over both methods is
        // a half.
        double mean = 1 - 0.5 / 256;
        double scale = 0.25 + 0.0025 * mean * mean;
        PilotScore score = scores.of(BuiltInMethod.RAYTRACE);
        assertEquals(16.0 * SAMPLES * 2 / scale / 256, score.missed(), 1e-9 * score.missed());
        assertEquals(0, score.variance());
    }

    @Test
    void lightWithinTheNoiseIsNotMissed() {
        List<PilotPicture> guard = noisy(0.1, 3);
        PilotScore score = scores(noisy(0.1, 4), guard).of(BuiltInMethod.RAYTRACE);
        // 768 blocks, each beyond three deviations with a probability of 0.00135: one in the mean, with an excess of a
        // third of a deviation.
        assertEquals(0, score.missed(), 0.1 * score.variance());
    }

    @Test
    void whereNothingIsBrightNothingIsUncertain() {
        List<PilotPicture> black = List.of(picture(new double[3 * SIDE * SIDE]), picture(new double[3 * SIDE * SIDE]));
        PilotScore score = scores(black, black).of(BuiltInMethod.RAYTRACE);
        assertEquals(0, score.work());
    }
}

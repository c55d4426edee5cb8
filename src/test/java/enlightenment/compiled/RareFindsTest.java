package enlightenment.compiled;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pixels whose rare light is known, and pictures of them by a random generator: some finds are worth far more than others. */
class RareFindsTest {
    private static final int PARTS = 1024;
    private static final double[] OTHER = {0.1, 0.05, 0.02};
    private static final double[] LIGHT = {0.3, 0.2, 0.1};

    /** One of 50 samples finds something; half of these nothing after all, and one of 16 nearly all of the light. */
    private static final double FOUND = 0.02;

    private static final double[] WORTH = {0, 0.1, 16};
    private static final double[] WEIGHT = {8, 7, 1};

    private static ChanceLight light(RareFinds finds, double found) {
        ChanceLight.Builder parts = new ChanceLight.Builder(PARTS / 32, 32);
        for (int k = 0; k < PARTS; k++) {
            parts.set(k, OTHER, LIGHT, found);
        }
        return parts.build(finds);
    }

    private static ChanceLight unequal() {
        return light(RareFinds.of(FOUND, WORTH, WEIGHT), 0);
    }

    private static double shown(int band, double share) {
        return DisplayCurve.SRGB.of(OTHER[band] + LIGHT[band] * share);
    }

    /** Of one sample, as a share of the mean. */
    private static double draw(Random random) {
        if (random.nextDouble() >= FOUND) {
            return 0;
        }
        double drawn = random.nextDouble() * 16;
        double mean = FOUND * (7 * 0.1 + 16) / 16;
        return (drawn < 8 ? 0 : drawn < 15 ? 0.1 : 16) / mean;
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 64, 512})
    void theErrorIsThatOfPicturesByARandomGenerator(int samples) {
        Random random = new Random(samples);
        double square = 0;
        double halves = 0;
        for (int k = 0; k < 16 * PARTS; k++) {
            double first = 0;
            double second = 0;
            for (int s = 0; s < samples / 2; s++) {
                first += 2 * draw(random) / samples;
                second += 2 * draw(random) / samples;
            }
            for (int c = 0; c < 3; c++) {
                double off = shown(c, (first + second) / 2) - shown(c, 1);
                double half = shown(c, first) - shown(c, second);
                square += off * off / (48 * PARTS);
                halves += half * half / 4 / (48 * PARTS);
            }
        }
        ChanceError error = unequal().error(DisplayCurve.SRGB, samples);
        // 16,384 pictures of a pixel each: 1.96 deviations of a mean of 1024 are at most 8 % where most pixels find
        // nothing.
        assertTrue(error.most() > 1.2 * square && error.most() < 1.45 * square, error.most() + " of " + square);
        // At least as much as the halves is told of it, and at most twice as much.
        assertTrue(error.shortfall() < 1.05 * (square - halves), error + " of " + (square - halves));
        assertTrue(error.shortfall() > 0.95 * square - 2 * halves, error + " of " + (square - 2 * halves));
    }

    @Test
    void findsThatAreAllWorthTheSameAreThoseOfLightThatIsFoundOrNot() {
        double[] one = {1};
        for (double samples : new double[] {8, 200, 1500}) {
            double equal = light(null, 1e-3).error(DisplayCurve.SRGB, samples).most();
            double played = light(RareFinds.of(1e-3, one, one), 0)
                    .error(DisplayCurve.SRGB, samples)
                    .most();
            // What is played through may be a quarter more than is known.
            assertEquals(1.25 * equal, played, 0.04 * equal);
        }
    }

    /** What finds nothing after all need not have been found. */
    @Test
    void findsOfNothingAreNone() {
        RareFinds some = RareFinds.of(0.02, new double[] {0, 3}, new double[] {9, 1});
        RareFinds few = RareFinds.of(0.002, new double[] {5}, new double[] {2});
        double a = light(some, 0).error(DisplayCurve.SRGB, 300).most();
        double b = light(few, 0).error(DisplayCurve.SRGB, 300).most();
        assertEquals(a, b, 0.03 * b);
        assertNull(RareFinds.of(0.02, new double[2], new double[] {1, 1}));
        assertNull(RareFinds.of(0.02, new double[0], new double[0]));
    }

    @Test
    void manySamplesTellAll() {
        assertEquals(ChanceError.NONE, unequal().error(DisplayCurve.SRGB, 1 << 20));
    }
}

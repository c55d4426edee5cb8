package enlightenment.compiled;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.EnumSet;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Pixels whose rare light is known, and pictures of them by a random generator. */
class ChanceLightTest {
    private static final int PARTS = 64;
    private static final double[] OTHER = {0.1, 0.05, 0.02};
    private static final double[] LIGHT = {0.3, 0.2, 0.1};
    private static final double FOUND = 1e-3;

    private static ChanceLight light() {
        ChanceLight.Builder parts = new ChanceLight.Builder(PARTS / 8, 8);
        for (int k = 0; k < PARTS; k++) {
            parts.set(k, OTHER, LIGHT, FOUND);
        }
        return parts.build();
    }

    /** The squared error of one picture with n samples per pixel, each of which meets all of the light with the probability q. */
    private static double squaredError(int samples, Random random) {
        double sum = 0;
        for (int k = 0; k < PARTS; k++) {
            int met = 0;
            for (int s = 0; s < samples; s++) {
                met += random.nextDouble() < FOUND ? 1 : 0;
            }
            for (int c = 0; c < 3; c++) {
                double shown = DisplayCurve.SRGB.of(OTHER[c] + LIGHT[c] * met / (samples * FOUND));
                double d = shown - DisplayCurve.SRGB.of(OTHER[c] + LIGHT[c]);
                sum += d * d;
            }
        }
        return sum / (3 * PARTS);
    }

    /** By a normal distribution: that of few pictures in which such light was met is more skewed. */
    @ParameterizedTest
    @ValueSource(ints = {16, 128, 500, 1500})
    void nearlyAllPicturesErrByNoMoreThanIsSaid(int samples) {
        ChanceError error = light().error(DisplayCurve.SRGB, samples);
        Random random = new Random(samples);
        int kept = 0;
        double mean = 0;
        for (int k = 0; k < 200; k++) {
            double square = squaredError(samples, random);
            kept += square <= error.most() ? 1 : 0;
            mean += square / 200;
        }
        assertTrue(kept >= 170, "of 200: " + kept);
        assertTrue(error.most() < 1.6 * mean, error.most() + " where it is " + mean);
        assertTrue(error.shortfall() < 1.1 * mean, error.shortfall() + " where it is " + mean);
    }

    @Test
    void fewSamplesTellNothingOfItAndManyTellAll() {
        ChanceLight light = light();
        ChanceError few = light.error(DisplayCurve.SRGB, 4);
        assertEquals(few.most(), few.shortfall(), 0.1 * few.most());
        assertEquals(ChanceError.NONE, light.error(DisplayCurve.SRGB, 1 << 20));
    }

    @Test
    void withoutSuchLightThereIsNothingToTell() {
        ChanceLight.Builder parts = new ChanceLight.Builder(2, 1);
        parts.set(0, OTHER, new double[3], 0);
        assertNull(parts.build());
    }

    private static ChanceLight neverFound() {
        ChanceLight.Builder parts = new ChanceLight.Builder(2, 1);
        parts.set(0, OTHER, LIGHT, 0);
        parts.set(1, OTHER, new double[3], 0);
        return parts.build();
    }

    /** Half of the picture lacks it, whatever the number of samples, and they agree. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 64, 1 << 20})
    void lightThatNoneEverFindsIsLackingForEver(double samples) {
        double square = 0;
        for (int c = 0; c < 3; c++) {
            double d = DisplayCurve.SRGB.of(OTHER[c] + LIGHT[c]) - DisplayCurve.SRGB.of(OTHER[c]);
            square += d * d / 6;
        }
        ChanceError error = neverFound().error(DisplayCurve.SRGB, samples);
        assertEquals(square, error.shortfall(), 0.01 * square);
        assertEquals(square, error.most(), 0.01 * square);
    }

    /** 64 parts and 1000 pixels: with 5 samples of each 5 of all find it, with 10 there are 10. */
    @Test
    void pixelsThatShareWhatTheyFindLackAllOfItOrNothing() {
        ChanceError never = neverFound().error(DisplayCurve.SRGB, 1);
        ChanceError few = light().error(DisplayCurve.SRGB, 5, 1000);
        assertEquals(2 * never.most(), few.shortfall(), 1e-6);
        assertEquals(few.shortfall(), few.most());
        assertEquals(ChanceError.NONE, light().error(DisplayCurve.SRGB, 10, 1000));
        assertEquals(
                never.most(),
                neverFound().error(DisplayCurve.SRGB, 1 << 20, 1000).most(),
                1e-9);
    }

    /** The left half of the picture has such light, and all of it; a tenth of the width around its end a half. */
    @Test
    void ofARectangleWhatLiesWithinItCounts() {
        ChanceLights all = ChanceLights.NONE.and(ChanceLights.Kind.POINTS_IN_MEDIA, neverFound());
        EnumSet<ChanceLights.Kind> kinds = EnumSet.allOf(ChanceLights.Kind.class);
        double whole = all.error(kinds, DisplayCurve.SRGB, 64).shortfall();
        for (double samples : new double[] {0, 64}) {
            assertEquals(2 * whole, error(all.within(0.1, 0.3, 0.2, 0.4), samples), 1e-6 * whole);
            assertEquals(0, error(all.within(0.5, 0, 0.6, 1), samples));
            assertEquals(whole, error(all.within(0.45, 0, 0.55, 1), samples), 1e-6 * whole);
            assertEquals(whole, error(all.within(0, 0, 1, 1), samples), 1e-6 * whole);
        }
    }

    /** @param samples 0 for pixels that share what they find */
    private static double error(ChanceLights light, double samples) {
        EnumSet<ChanceLights.Kind> kinds = EnumSet.allOf(ChanceLights.Kind.class);
        return samples > 0
                ? light.error(kinds, DisplayCurve.SRGB, samples).shortfall()
                : light.error(kinds, DisplayCurve.SRGB, 1, 100).shortfall();
    }

    @Test
    void theErrorsOfSeveralKindsAddUp() {
        ChanceLights none = ChanceLights.NONE.and(ChanceLights.Kind.SURFACES, null);
        ChanceLights both =
                none.and(ChanceLights.Kind.SURFACES, light()).and(ChanceLights.Kind.POINTS_IN_MEDIA, neverFound());
        EnumSet<ChanceLights.Kind> all = EnumSet.allOf(ChanceLights.Kind.class);
        assertEquals(ChanceError.NONE, none.error(all, DisplayCurve.SRGB, 64));
        ChanceError one = both.error(EnumSet.of(ChanceLights.Kind.POINTS_IN_MEDIA), DisplayCurve.SRGB, 64);
        ChanceError two = both.error(all, DisplayCurve.SRGB, 64);
        assertEquals(neverFound().error(DisplayCurve.SRGB, 64), one);
        assertEquals(one.shortfall() + light().error(DisplayCurve.SRGB, 64).shortfall(), two.shortfall());
    }
}

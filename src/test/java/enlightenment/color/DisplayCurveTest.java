package enlightenment.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.math.InvalidValueException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DisplayCurveTest {
    @Test
    void displayReferredNumbersStayAsTheyAre() {
        for (double v : new double[] {-2, 0, 0.3, 1, 7, Double.POSITIVE_INFINITY}) {
            assertEquals(v, DisplayCurve.NONE.of(v));
            assertEquals(v, DisplayCurve.NONE.nearly(v));
        }
        assertThrows(IllegalStateException.class, () -> DisplayCurve.NONE.withExposure(1));
    }

    @Test
    void withoutExposureItIsTheCurveOfSrgbAndClips() {
        for (double v : new double[] {0, 1e-300, 0.001, 0.0031308, 0.18, 0.5, 0.999}) {
            assertEquals(TransferCurve.encode(v), DisplayCurve.SRGB.of(v));
        }
        assertEquals(1, DisplayCurve.SRGB.of(1));
        assertEquals(1, DisplayCurve.SRGB.of(Double.POSITIVE_INFINITY));
        assertEquals(0, DisplayCurve.SRGB.of(-1));
        assertTrue(Double.isNaN(DisplayCurve.SRGB.of(Double.NaN)));
    }

    @ParameterizedTest
    @EnumSource(DisplayCurve.Tone.class)
    void aStopIsTwiceTheLight(DisplayCurve.Tone tone) {
        for (double v : new double[] {0.001, 0.02, 0.1, 0.3}) {
            assertEquals(
                    DisplayCurve.of(0, tone).of(2 * v), DisplayCurve.of(1, tone).of(v));
            assertEquals(
                    DisplayCurve.of(0, tone).of(v / 8),
                    DisplayCurve.of(-3, tone).of(v));
        }
        assertEquals(DisplayCurve.of(2, tone), DisplayCurve.of(-5, tone).withExposure(2));
    }

    @Test
    void filmicIsNarkowiczsFraction() {
        DisplayCurve curve = DisplayCurve.of(0, DisplayCurve.Tone.FILMIC);
        assertEquals(
                TransferCurve.encode(0.18 * (2.51 * 0.18 + 0.03) / (0.18 * (2.43 * 0.18 + 0.59) + 0.14)),
                curve.of(0.18),
                1e-15);
        assertEquals(TransferCurve.encode(2.54 / 3.16), curve.of(1), 1e-15);
        // 0.08 x² − 0.56 x − 0.14 = 0.
        assertTrue(curve.of(7.2) < 1);
        assertEquals(1, curve.of(7.25));
        assertEquals(1, curve.of(1e300));
    }

    @ParameterizedTest
    @EnumSource(DisplayCurve.Tone.class)
    void itNeverFallsAndTheTableIsNear(DisplayCurve.Tone tone) {
        DisplayCurve curve = DisplayCurve.of(0.5, tone);
        double last = 0;
        for (int i = 0; i <= 40_000; i++) {
            double x = 9.0 * i / 40_000 * i / 40_000;
            double y = curve.of(x);
            assertTrue(y >= last && y <= 1, "at " + x);
            assertEquals(y, curve.nearly(x), 1e-6, "at " + x);
            last = y;
        }
        assertEquals(0, curve.nearly(Double.NaN));
        assertEquals(1, curve.nearly(Double.POSITIVE_INFINITY));
    }

    /** Dispersion makes colours that no screen has: the fraction of the filmic curve has poles below 0. */
    @ParameterizedTest
    @EnumSource(DisplayCurve.Tone.class)
    void negativeLightIsBlackByTheTableToo(DisplayCurve.Tone tone) {
        DisplayCurve curve = DisplayCurve.of(2, tone);
        for (double v : new double[] {-1e-300, -0.01, -0.03, -0.05, -0.2, -1, -50, -1e300, Double.NEGATIVE_INFINITY}) {
            assertEquals(0, curve.of(v), "of " + v);
            assertEquals(0, curve.nearly(v), "nearly " + v);
        }
    }

    @Test
    void exposuresThatNobodyCanMeanAreRefused() {
        for (double stops : new double[] {1001, -1001, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(InvalidValueException.class, () -> DisplayCurve.of(stops, DisplayCurve.Tone.CLIP));
        }
        assertNotEquals(DisplayCurve.of(0, DisplayCurve.Tone.CLIP), DisplayCurve.of(0, DisplayCurve.Tone.FILMIC));
        assertNotEquals(DisplayCurve.NONE, DisplayCurve.SRGB);
    }
}

package enlightenment.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.colorimetry.TransferCurve;
import enlightenment.math.InvalidValueException;
import java.math.BigDecimal;
import java.math.MathContext;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RgbTest {
    @Test
    void lightHasNoUpperLimitButIsNeverNegativeInfiniteOrNoNumber() {
        assertEquals(Double.MAX_VALUE, new Rgb(Double.MAX_VALUE, 0, 1).r());
        for (double bad : new double[] {-Double.MIN_VALUE, Double.POSITIVE_INFINITY, Double.NaN}) {
            assertEquals(
                    "r",
                    assertThrows(InvalidValueException.class, () -> new Rgb(bad, 0, 0))
                            .key());
            assertEquals(
                    "g",
                    assertThrows(InvalidValueException.class, () -> new Rgb(0, bad, 0))
                            .key());
            assertEquals(
                    "b",
                    assertThrows(InvalidValueException.class, () -> new Rgb(0, 0, bad))
                            .key());
        }
    }

    @Test
    void onlyThreeZerosAreBlack() {
        assertTrue(Rgb.BLACK.isBlack());
        assertTrue(new Rgb(-0.0, 0, -0.0).isBlack());
        assertFalse(new Rgb(Double.MIN_VALUE, 0, 0).isBlack());
        assertFalse(new Rgb(0, Double.MIN_VALUE, 0).isBlack());
        assertFalse(new Rgb(0, 0, Double.MIN_VALUE).isBlack());
    }

    @Test
    void blackAndWhiteStayWhatTheyAre() {
        assertEquals(Rgb.BLACK, Rgb.of(DisplayRgb.BLACK));
        assertEquals(new Rgb(1, 1, 1), Rgb.of(DisplayRgb.WHITE));
    }

    /** The curve of IEC 61966-2-1: x^2.4 is the fifth root of x^12, so exact decimals can judge it without any pow. */
    @ParameterizedTest
    @ValueSource(ints = {11, 12, 50, 127, 128, 200, 254})
    void aDisplayColourIsDecodedByTheCurveOfTheStandard(int step) {
        double encoded = step / 255.0;
        double linear = Rgb.of(new DisplayRgb(encoded, 0, 0)).r();
        MathContext digits = new MathContext(60);
        BigDecimal base = new BigDecimal(encoded).add(new BigDecimal("0.055")).divide(new BigDecimal("1.055"), digits);
        BigDecimal fifthPower = new BigDecimal(linear).pow(5, digits);
        // A relative error e of the root is one of 5 e of its fifth power.
        double error = fifthPower
                .subtract(base.pow(12, digits))
                .divide(fifthPower, digits)
                .doubleValue();
        assertTrue(Math.abs(error) < 5 * 8 * Math.ulp(1.0), step + ": " + error);
    }

    @Test
    void darkColoursAreDecodedByTheLineOfTheStandard() {
        assertEquals(10 / 255.0 / 12.92, Rgb.of(DisplayRgb.ofBytes(10, 0, 0)).r());
    }

    @Test
    void aColourIsBothWhatAScreenShowsAndLight() {
        DisplayRgb shown = DisplayRgb.ofBytes(10, 128, 255);
        Color color = shown;
        assertEquals(shown, color.display());
        assertEquals(Rgb.of(shown), color.linear());
        Rgb light = new Rgb(0.25, 3e9, 0);
        color = light;
        assertEquals(light, color.linear());
        assertEquals(new DisplayRgb(TransferCurve.encode(0.25), 1, 0), color.display());
    }

    @Test
    void noLightIsBrighterOnAScreenThanWhite() {
        for (double light : new double[] {Math.nextDown(1.0), 1, Math.nextUp(1.0), 2, Double.MAX_VALUE}) {
            DisplayRgb shown = Rgb.gray(light).display();
            assertTrue(shown.g() <= 1 && shown.g() >= 1 - 1e-15, light + ": " + shown);
        }
    }

    @Test
    void bandsAreMultipliedEachOnItsOwn() {
        assertEquals(new Rgb(2, 0, 21), new Rgb(1, 5, 3).times(new Rgb(2, 0, 7)));
        Rgb bright = Rgb.gray(1e200);
        assertThrows(InvalidValueException.class, () -> bright.times(bright));
        assertEquals(5, new Rgb(1, 5, 3).max());
    }

    @Test
    void encodingUndoesDecoding() {
        for (int step = 0; step <= 255; step++) {
            double encoded = step / 255.0;
            assertEquals(encoded, TransferCurve.encode(TransferCurve.decode(encoded)), 4 * Math.ulp(1.0), "" + step);
        }
    }
}

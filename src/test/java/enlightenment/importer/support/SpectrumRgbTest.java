package enlightenment.importer.support;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import org.junit.jupiter.api.Test;

class SpectrumRgbTest {
    private static void assertNear(double r, double g, double b, Rgb actual, double tolerance) {
        assertEquals(r, actual.r(), tolerance);
        assertEquals(g, actual.g(), tolerance);
        assertEquals(b, actual.b(), tolerance);
    }

    @Test
    void aConstantReflectanceIsGrey() {
        assertNear(0.25, 0.25, 0.25, SpectrumRgb.underDaylight(w -> 0.25), 1e-12);
    }

    @Test
    void theWhiteOfSrgbIsWhite() {
        assertNear(1, 1, 1, SpectrumRgb.ofChromaticity(0.3127, 0.3290), 2e-3);
    }

    @Test
    void redReflectancesAreRed() {
        Rgb red = SpectrumRgb.underDaylight(w -> w > 600 ? 1 : 0);
        assertTrue(red.r() > 5 * red.g() && red.r() > 20 * red.b(), red.toString());
    }

    /** Planckian locus (CIE 15): 2856 K is at x = 0.4476, y = 0.4074; 6500 K at 0.3135, 0.3237. */
    @Test
    void blackBodiesLieOnThePlanckianLocus() {
        Rgb a = SpectrumRgb.ofChromaticity(0.4476, 0.4074);
        assertNear(a.r(), a.g(), a.b(), SpectrumRgb.blackbody(2856), 0.02);
        Rgb b = SpectrumRgb.ofChromaticity(0.3135, 0.3237);
        assertNear(b.r(), b.g(), b.b(), SpectrumRgb.blackbody(6500), 0.02);
    }

    @Test
    void lightHasLuminanceOne() {
        assertEquals(1, SpectrumRgb.luminance(SpectrumRgb.blackbody(1000)), 1e-12);
        assertEquals(1, SpectrumRgb.luminance(SpectrumRgb.ofLight(w -> w)), 1e-12);
        assertEquals(Rgb.BLACK, SpectrumRgb.ofLight(w -> 0));
    }

    @Test
    void samplesAreJoinedByLines() {
        var s = SpectrumRgb.linear(new double[] {400, 500, 700}, new double[] {1, 3, 0});
        assertEquals(0, s.applyAsDouble(399));
        assertEquals(1, s.applyAsDouble(400));
        assertEquals(2, s.applyAsDouble(450));
        assertEquals(1.5, s.applyAsDouble(600));
        assertEquals(0, s.applyAsDouble(701));
    }

    @Test
    void wavelengthsMustGrow() {
        double[] same = {400, 400};
        assertThrows(IllegalArgumentException.class, () -> SpectrumRgb.linear(same, same));
        assertThrows(IllegalArgumentException.class, () -> SpectrumRgb.blackbody(0));
    }
}

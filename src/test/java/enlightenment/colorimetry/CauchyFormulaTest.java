package enlightenment.colorimetry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CauchyFormulaTest {
    private static double index(double index, double abbe, double wavelength) {
        return CauchyFormula.index(index, CauchyFormula.slope(index, abbe), CauchyFormula.place(wavelength));
    }

    @ParameterizedTest
    @CsvSource({"1.5168, 64.17", "1.805, 25.4", "1.333, 55.8", "0.8, 10"})
    void theIndexAndTheAbbeNumberAreWhatTheyAreDefinedAs(double index, double abbe) {
        assertEquals(index, index(index, abbe, 587.6));
        double difference = index(index, abbe, 486.1) - index(index, abbe, 656.3);
        assertEquals(abbe, (index - 1) / difference, 1e-9 * abbe);
    }

    /** Schott's catalogue: N-BK7 at the lines F, C and r. Two terms are good to three digits there. */
    @ParameterizedTest
    @CsvSource({"486.1, 1.52238", "656.3, 1.51432", "706.5, 1.51289"})
    void theIndicesOfCrownGlassAreAboutThoseOfTheCatalogue(double wavelength, double expected) {
        assertEquals(expected, index(1.5168, 64.17, wavelength), 1e-3);
    }
}

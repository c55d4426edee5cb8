package enlightenment.colorimetry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BandSensitivitiesTest {
    private static final BandSensitivities DAYLIGHT = BandSensitivities.DAYLIGHT;

    @Test
    void eachBandAddsUpToOne() {
        for (int band = 0; band < 3; band++) {
            double sum = 0;
            for (double nm = BandSensitivities.SHORTEST + 0.5; nm < BandSensitivities.LONGEST; nm++) {
                sum += DAYLIGHT.sensitivity(nm, band);
            }
            assertEquals(1, sum, 1e-12);
        }
    }

    @Test
    void theWeightsOfWhatIsDrawnAreOneInTheMeanAndBounded() {
        int n = 1 << 16;
        double[] sums = new double[3];
        double last = BandSensitivities.SHORTEST;
        for (int k = 0; k < n; k++) {
            double nm = DAYLIGHT.draw((k + 0.5) / n);
            assertTrue(nm >= last && nm < BandSensitivities.LONGEST, "drawn in order: " + nm);
            last = nm;
            for (int band = 0; band < 3; band++) {
                double weight = DAYLIGHT.weight(nm, band);
                assertTrue(Math.abs(weight) < 4.5, "weight " + weight);
                sums[band] += weight / n;
            }
        }
        for (double sum : sums) {
            assertEquals(1, sum, 1e-4);
        }
        assertEquals(BandSensitivities.SHORTEST, DAYLIGHT.draw(0));
        assertTrue(DAYLIGHT.draw(Math.nextDown(1.0)) < BandSensitivities.LONGEST);
    }

    /** Which bands see the line of a lamp, and which it takes away from: helium, hydrogen, mercury, sodium. */
    @ParameterizedTest
    @CsvSource({
        "404.7, 1, -1, 1",
        "435.8, 1, -1, 1",
        "486.1, -1, 1, 1",
        "546.1, -1, 1, -1",
        "587.6, 1, 1, -1",
        "656.3, 1, -1, -1"
    })
    void spectralLinesHaveTheSignsOfTheirColours(double nm, int red, int green, int blue) {
        assertEquals(red, Math.signum(DAYLIGHT.sensitivity(nm, 0)));
        assertEquals(green, Math.signum(DAYLIGHT.sensitivity(nm, 1)));
        assertEquals(blue, Math.signum(DAYLIGHT.sensitivity(nm, 2)));
    }

    /** The observer's tables of 1931 (CIE 15:2018) times daylight: to what the sums of Gaussians are off by, 1 % of the largest. */
    @ParameterizedTest
    @CsvSource({
        "450, 0.3362, 0.0380, 1.77211, 117.008",
        "500, 0.0049, 0.3230, 0.2720, 109.354",
        "550, 0.4334495, 0.9949501, 0.0087499, 104.046",
        "600, 1.0622, 0.6310, 0.0008, 90.0062",
        "650, 0.2835, 0.1070, 0, 80.0268"
    })
    void theyAreThoseOfTheStandardObserverInDaylight(double nm, double x, double y, double z, double daylight) {
        // The sum of y times daylight, every nanometre: table 1 of CIE 15 gives 10566.864 for 1 nm (380 to 780).
        double scale = daylight / 10566.864;
        double[] expected = {
            scale * (3.2406 * x - 1.5372 * y - 0.4986 * z),
            scale * (-0.9689 * x + 1.8758 * y + 0.0415 * z),
            scale * (0.0557 * x - 0.2040 * y + 1.0570 * z)
        };
        for (int band = 0; band < 3; band++) {
            assertEquals(expected[band], DAYLIGHT.sensitivity(nm, band), 6e-4, "band " + band);
        }
    }
}

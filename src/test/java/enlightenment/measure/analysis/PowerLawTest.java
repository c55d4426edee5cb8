package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.image.ImageError;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PowerLawTest {
    /** Gradients of 40 × 30 pixels: no component is at the edge of the range. */
    private static final int WIDTH = 40;

    private static final int HEIGHT = 30;

    @Test
    void pointsOnALineGiveTheLineAndNoSpread() {
        double[] x = {1, 2, 4, 8};
        double[] y = {3, 3 / Math.sqrt(2), 1.5, 1.5 / Math.sqrt(2)};
        PowerLaw law = PowerLaw.fit(x, y);
        assertEquals(-0.5, law.slope(), 1e-14);
        assertEquals(3, law.factor(), 1e-13);
        assertEquals(0, law.slopeHigh() - law.slopeLow(), 1e-12);
        assertEquals(0.75, law.at(16), 1e-13);
    }

    /** Tables of Student's distribution, 97.5 %. */
    @ParameterizedTest
    @CsvSource({"1, 12.706", "2, 4.303", "3, 3.182", "4, 2.776", "5, 2.571", "10, 2.228", "30, 2.042", "1000, 1.962"})
    void studentsQuantilesAreThoseOfTheTables(int degrees, double quantile) {
        assertEquals(quantile, PowerLaw.student(degrees), 0.01 * quantile);
    }

    /** With 1000 fits of 95 %, 950 ± 7 intervals hold the slope; four deviations to either side pass. */
    @Test
    void theIntervalHoldsTheSlopeAsOftenAsItSays() {
        Random random = new Random(1);
        int held = 0;
        for (int k = 0; k < 1000; k++) {
            double[] x = new double[9];
            double[] y = new double[9];
            for (int i = 0; i < x.length; i++) {
                x[i] = 1 << i / 3 * 2;
                y[i] = 0.1 * Math.pow(x[i], -0.7) * Math.exp(0.2 * random.nextGaussian());
            }
            PowerLaw law = PowerLaw.fit(x, y);
            held += law.slopeLow() <= -0.7 && -0.7 <= law.slopeHigh() ? 1 : 0;
        }
        assertTrue(held >= 922 && held <= 978, held + " of 1000");
    }

    /** Pictures that are means of n independent samples: σ/√n is their error, by construction. */
    @Test
    void independentSamplesHaveASlopeOfOneHalf() {
        Random random = new Random(2);
        Image truth = SyntheticImages.gradient(WIDTH, HEIGHT);
        double[] samples = new double[15];
        double[] errors = new double[15];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = 1 << i / 3;
            Image noisy = SyntheticImages.meanOfSamples(truth, (int) samples[i], 0.1, random);
            errors[i] = ImageError.between(noisy, truth).rmse();
            // An RMSE over 3600 components scatters by 1/√7200 of itself.
            assertEquals(0.1 / Math.sqrt(samples[i]), errors[i], 5 * errors[i] / Math.sqrt(7200));
        }
        PowerLaw law = PowerLaw.fit(samples, errors);
        assertEquals(-0.5, law.slope(), 0.02);
        assertTrue(law.slopeLow() < -0.5 && -0.5 < law.slopeHigh(), law.toString());
    }

    @Test
    void whatGivesNoLineIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> PowerLaw.fit(new double[] {1}, new double[] {1}));
        assertThrows(IllegalArgumentException.class, () -> PowerLaw.fit(new double[] {2, 2}, new double[] {1, 3}));
        assertThrows(IllegalArgumentException.class, () -> PowerLaw.fit(new double[] {1, 2}, new double[] {1, 0}));
    }
}

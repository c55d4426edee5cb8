package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The interval of linear light where few pixels carry the error. */
class LightIntervalTest {
    private static final int SIDE = 32;
    private static final int SAMPLES = 64;
    private static final double LIGHT = 0.5;
    private static final DisplayCurve CURVE = DisplayCurve.SRGB;

    /** A dark picture in which some pixels are noisy, each with {@code fall} of the deviation of the one before it. */
    private static Film hall(int lit, double fall, double deviation, int samples, Random random) {
        FilmTile tile = new FilmTile(0, 0, SIDE, SIDE, CURVE);
        SampleSpread spread = new SampleSpread();
        for (int i = 0; i < SIDE * SIDE; i++) {
            boolean isLit = i < lit;
            double own = isLit ? deviation * Math.pow(fall, i) : 0;
            spread.begin(samples);
            for (int s = 0; s < samples; s++) {
                double v = isLit ? LIGHT + own * random.nextGaussian() : 0;
                tile.add(i % SIDE, i / SIDE, v, v, v);
                spread.at(0.5, 0.5);
                spread.add(v, v, v);
            }
            tile.spread(i % SIDE, i / SIDE, spread);
        }
        Film film = new Film(0, 0, SIDE, SIDE, CURVE);
        film.put(tile);
        return film;
    }

    private static double error(Film film, int lit) {
        double sum = 0;
        for (int i = 0; i < lit; i++) {
            double d = CURVE.of(film.component(i % SIDE, i / SIDE, 0)) - CURVE.of(LIGHT);
            sum += d * d;
        }
        return Math.sqrt(sum) / SIDE;
    }

    /**
     * Of m pixels the square of the error has the χ² distribution of m degrees of freedom, and nobody can tell more of it than three
     * contrasts of each do: the F distribution of m and 3 m. Its 97.5 % quantile is 17.4 for one pixel, 7.3 for two and 4.1 for four, of
     * the mean; the 95 % quantile of χ²/m, 3.8, 3 and 2.4, is what is needed at least.
     */
    @ParameterizedTest
    @CsvSource({"1, 1, 6", "2, 1, 4", "4, 1, 3", "16, 1, 2.5", "16, 0.8, 3", "300, 1, 2"})
    void theUpperEndHoldsTheErrorOfFewPixelsAndIsNotMuchMoreThanNeeded(int lit, double fall, double most) {
        int pictures = lit > 100 ? 100 : 400;
        Random random = new Random(lit);
        double[] errors = new double[pictures];
        double[] ends = new double[pictures];
        int above = 0;
        for (int k = 0; k < pictures; k++) {
            Film film = hall(lit, fall, 0.4, SAMPLES, random);
            errors[k] = error(film, lit);
            ends[k] = film.error().high();
            above += errors[k] > ends[k] ? 1 : 0;
        }
        Arrays.sort(errors);
        Arrays.sort(ends);
        double surplus = Math.pow(ends[pictures / 2] / errors[(int) (0.95 * pictures)], 2);
        // 2.5 % expected; 19 or more of 400 have a probability of 1 %.
        assertTrue(above <= 0.0475 * pictures, above + " of " + pictures + " above");
        assertTrue(surplus < most, "so many times the samples that are needed: " + surplus);
    }

    @Test
    void aBlackPictureOfASingleSampleMayLackAPixelThatIsWhite() {
        double high = hall(0, 1, 0, 1, new Random(1)).error().high();
        // Three pixels that are white.
        assertEquals(Math.sqrt(3) / SIDE, high, 1e-6);
    }

    @Test
    void halvesThatAgreeByChanceAreNotTakenForNoError() {
        FilmTile tile = new FilmTile(0, 0, 1, 1, CURVE);
        SampleSpread spread = new SampleSpread();
        spread.begin(4);
        for (double v : new double[] {0, 1, 1, 0}) {
            tile.add(0, 0, v, v, v);
            spread.add(v, v, v);
        }
        tile.spread(0, 0, spread);
        Film film = new Film(0, 0, 1, 1, CURVE);
        film.put(tile);
        // Quarters 0 and 1 in both halves. A mean of four such deviates by a quarter.
        assertTrue(film.error().high() > 0.25, "" + film.error().high());
    }

    @ParameterizedTest
    @ValueSource(doubles = {3, 6, 20, 400})
    void quantilesOfTheFDistributionAreThoseOfTheClosedForm(double below) {
        // Of two degrees of freedom above the distribution function is 1 − (1 + 2 x/b)^(−b/2).
        double exact = below / 2 * (Math.pow(0.025, -2 / below) - 1);
        assertEquals(1, LightInterval.fQuantile(1.96, 2, below) / exact, below < 6 ? 0.15 : 0.02);
        assertEquals(1, LightInterval.fQuantile(0, 500, 500), 1e-3);
    }

    @Test
    void theTrigammaFunctionHasItsKnownValues() {
        double ofOne = Math.PI * Math.PI / 6;
        assertEquals(ofOne, LightInterval.trigamma(1), 1e-6);
        assertEquals(ofOne - 1, LightInterval.trigamma(2), 1e-6);
        assertEquals(3 * ofOne, LightInterval.trigamma(0.5), 1e-6);
        assertEquals(1e-4, LightInterval.trigamma(1e4), 1e-8);
    }

    @Test
    void aPixelIsRareWhereItsQuartersTellOfHalfOfItsLightOrMore() {
        assertTrue(isRare(0.1, 0, 0, 0));
        // Of one hit each the pixel has met four, and deviates by half of itself.
        assertFalse(isRare(0.1, 0.1, 0.1, 0.1));
        assertFalse(isRare(0.15, 0.05, 0.1, 0.1));
        assertTrue(isRare(0.3, 0, 0.05, 0.05));
        assertTrue(QuarterMeans.isRare(CURVE, quarters(0.1, 0.1, 0.1, 0.1), 3));
    }

    @Test
    void aPixelIsRareWhereItsBrightestQuarterIsWhiterThanWhite() {
        // The mean 0.8 deviates by a quarter of itself only, but of 0.6 more the screen shows 0.2.
        assertTrue(isRare(0.6, 0.6, 0.6, 1.4));
        assertFalse(isRare(0.7, 0.7, 0.8, 0.8));
    }

    private static boolean isRare(double... means) {
        return QuarterMeans.isRare(CURVE, quarters(means), 16);
    }

    private static double[] quarters(double... means) {
        double[] all = new double[QuarterMeans.PER_PIXEL];
        for (int i = 0; i < all.length; i++) {
            all[i] = means[i / 3];
        }
        return all;
    }
}

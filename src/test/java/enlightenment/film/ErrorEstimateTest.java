package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Sobol;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures whose truth and noise are known. */
class ErrorEstimateTest {
    private static final double MEAN = 0.4;

    /** A picture in tiles of 8 × 8, of samples with this deviation around a ramp. */
    private static Film noisy(int width, int height, int samples, double deviation, double ramp, Random random) {
        Film film = new Film(0, 0, width, height);
        SampleSpread spread = new SampleSpread();
        for (int ty = 0; ty < height; ty += 8) {
            for (int tx = 0; tx < width; tx += 8) {
                FilmTile tile = new FilmTile(tx, ty, Math.min(8, width - tx), Math.min(8, height - ty));
                for (int y = ty; y < ty + tile.height; y++) {
                    for (int x = tx; x < tx + tile.width; x++) {
                        spread.begin(samples);
                        long seed = random.nextLong();
                        for (int s = 0; s < samples; s++) {
                            double dx = Sobol.x(s, seed);
                            double v = MEAN + ramp * (x + dx - 0.5) + deviation * random.nextGaussian();
                            tile.add(x, y, v, v, v);
                            spread.at(dx, Sobol.y(s, seed));
                            spread.add(v, v, v);
                        }
                        tile.spread(x, y, spread);
                    }
                }
                film.put(tile);
            }
        }
        return film;
    }

    private static double trueError(Film film, double ramp) {
        double sum = 0;
        for (int y = 0; y < film.height; y++) {
            for (int x = 0; x < film.width; x++) {
                double d = film.component(x, y, 1) - MEAN - ramp * x;
                sum += d * d;
            }
        }
        return Math.sqrt(sum / (film.width * film.height));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 9, 16, 25, 64})
    void ofIndependentSamplesTheEstimateIsTheDeviationOfTheMean(int samples) {
        Film film = noisy(96, 96, samples, 0.25, 0, new Random(samples));
        double expected = 0.25 / Math.sqrt(samples);
        // H²/(Q − H) of sums over N pixels has the relative variance (9 · 2 + 4)/N, its root half the deviation: 2.4 %
        // for
        // 9216. Four of that below; above less, since a ratio below 2 is not believed. Uneven halves of three samples
        // err by
        // √(9/8) on the side of caution.
        double high = samples == 3 ? 1.1 : 1.04;
        double ratio = film.error().rmse() / expected;
        assertTrue(ratio > 0.9 && ratio < high, samples + " samples: " + ratio);
    }

    @ParameterizedTest
    @CsvSource({"32, 32, 1", "32, 32, 2", "48, 32, 4", "24, 24, 16", "64, 48, 2", "32, 24, 9"})
    void theIntervalHoldsTheTrueErrorAboutAsOftenAsItSays(int width, int height, int samples) {
        Random random = new Random(7L * width + samples);
        int runs = 200;
        int above = 0;
        int held = 0;
        for (int r = 0; r < runs; r++) {
            Film film = noisy(width, height, samples, 0.1, 0, random);
            double truth = trueError(film, 0);
            ErrorEstimate e = film.error();
            held += truth >= e.low() && truth <= e.high() ? 1 : 0;
            above += truth > e.high() ? 1 : 0;
        }
        // 190 expected, deviation √(200 · 0.95 · 0.05) = 3.1; three of them.
        assertTrue(held >= 0.9 * runs, held + " of " + runs + " are held, " + above + " above");
    }

    @ParameterizedTest
    @Tag("full")
    @CsvSource({"48, 48, 4", "48, 48, 16", "96, 96, 4", "96, 48, 9"})
    void norIsItTooNarrowInLargerPictures(int width, int height, int samples) {
        theIntervalHoldsTheTrueErrorAboutAsOftenAsItSays(width, height, samples);
    }

    /** What neighbours differ by because the picture does is not taken for noise. */
    @Test
    void singleSamplesOnARampAreJudgedByTheirNoise() {
        double ramp = 0.02;
        Film film = noisy(64, 64, 1, 0.05, ramp, new Random(1));
        assertEquals(0.05, trueError(film, ramp), 0.002);
        assertEquals(0.05, film.error().rmse(), 0.1 * 0.05);
    }

    @Test
    void aSinglePixelOfASingleSampleIsWorthItsDistanceFromWhatIsKnown() {
        FilmTile tile = new FilmTile(0, 0, 1, 1);
        tile.known(0, 0, 0.5, 0.5, 0.5, 1);
        tile.add(0, 0, 0.1, 0.1, 0.1);
        Film film = new Film(0, 0, 1, 1);
        film.put(tile);
        assertEquals(0.6, film.component(0, 0, 0), 1e-15);
        assertEquals(0.1, film.error().rmse(), 1e-8);
    }

    @Test
    void anUnfinishedPictureIsJudgedByItsFinishedPixels() {
        Film film = new Film(0, 0, 16, 8);
        assertEquals(0, film.error().rmse());
        assertEquals(0, film.error().pixels());
        FilmTile tile = new FilmTile(8, 0, 8, 8);
        SampleSpread spread = new SampleSpread();
        Random random = new Random(2);
        for (int k = 0; k < 64; k++) {
            spread.begin(2);
            int first = random.nextInt(2);
            for (int s = 0; s < 2; s++) {
                int v = s ^ first;
                tile.add(8 + k % 8, k / 8, v, v, v);
                spread.at(Sobol.x(s, k), Sobol.y(s, k));
                spread.add(v, v, v);
            }
            tile.spread(8 + k % 8, k / 8, spread);
        }
        film.put(tile);
        assertEquals(64, film.error().pixels());
        // Two samples 0 and 1, either first: (0 − 1)²/4 if they were independent, and less as all means are alike.
        double rmse = film.error().rmse();
        assertTrue(rmse > 0.25 && rmse < 0.5, "" + rmse);
        assertEquals(0, film.error().variances()[0]);
        assertEquals(rmse * rmse, film.error().variances()[8], 1e-7);
    }

    @Test
    void aPictureWithoutNoiseHasNoError() {
        ErrorEstimate e = noisy(16, 16, 16, 0, 0, new Random(0)).error();
        assertEquals(0, e.rmse(), 1e-15);
        assertEquals(0, e.low(), 1e-15);
        assertEquals(0, e.high(), 1e-15);
    }

    /** Samples so well distributed that the variance falls with the square of their number. */
    @Test
    void fasterConvergenceIsSeen() {
        Random random = new Random(3);
        FilmTile tile = new FilmTile(0, 0, 96, 96);
        SampleSpread spread = new SampleSpread();
        double errors = 0;
        for (int k = 0; k < 96 * 96; k++) {
            spread.begin(16);
            double sum = 0;
            double shift = random.nextDouble();
            for (int s = 0; s < 16; s++) {
                // Van der Corput's points, shifted as one: every aligned run of 2^k is an even comb, and V(n) = 1/(12
                // n²).
                double v = shift + (Integer.reverse(s) >>> 1) * 0x1p-31;
                v -= Math.floor(v);
                tile.add(k % 96, k / 96, v, v, v);
                spread.add(v, v, v);
                sum += v / 16;
            }
            tile.spread(k % 96, k / 96, spread);
            errors += (sum - 0.5) * (sum - 0.5) / (96 * 96);
        }
        Film film = new Film(0, 0, 96, 96);
        film.put(tile);
        assertEquals(1.0 / (12 * 256), errors, 0.05 / (12 * 256));
        // Few pictures are that smooth: a little caution.
        double ratio = film.error().rmse() / Math.sqrt(errors);
        assertTrue(ratio > 0.95 && ratio < 1.2, "" + ratio);
    }
}

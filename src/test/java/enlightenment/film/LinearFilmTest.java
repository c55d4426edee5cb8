package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Films of linear light: quarters, passes, what is splatted, samples that are no numbers. */
class LinearFilmTest {
    private static final DisplayCurve CURVE = DisplayCurve.of(0.7, DisplayCurve.Tone.FILMIC);

    private static FilmTile tile(double[][] samples, DisplayCurve curve) {
        FilmTile tile = new FilmTile(0, 0, 1, 1, curve);
        SampleSpread spread = new SampleSpread();
        spread.begin(samples.length);
        for (double[] s : samples) {
            tile.add(0, 0, s[0], s[1], s[2]);
            spread.at(0.5, 0.5);
            spread.add(s[0], s[1], s[2]);
        }
        tile.spread(0, 0, spread);
        return tile;
    }

    private static double[][] samples(int n, long seed) {
        Random random = new Random(seed);
        double[][] samples = new double[n][3];
        for (double[] s : samples) {
            for (int c = 0; c < 3; c++) {
                s[c] = 0.2 * (c + 1) * -StrictMath.log(1 - random.nextDouble());
            }
        }
        return samples;
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 64})
    void halvesAndQuartersAreThoseOfWhatIsShown(int n) {
        double[][] samples = samples(n, n);
        double halves = 0;
        double quarters = 0;
        for (int c = 0; c < 3; c++) {
            double[] q = new double[4];
            for (int i = 0; i < n; i++) {
                q[4 * i / n] += samples[i][c] * 4 / n;
            }
            double a = CURVE.of((q[0] + q[1]) / 2) - CURVE.of((q[2] + q[3]) / 2);
            halves += a * a / 4 / 3;
            double b = CURVE.of(q[0]) - CURVE.of(q[1]);
            double d = CURVE.of(q[2]) - CURVE.of(q[3]);
            quarters += (b * b + d * d) / 2 / 4 / 3;
        }
        FilmTile tile = tile(samples, CURVE);
        assertEquals(halves, tile.halves(0, 0), 1e-5 * halves);
        assertEquals(quarters, tile.quarters(0, 0), 1e-5 * quarters);
    }

    @Test
    void withoutACurveToBendThemTheyAreThoseOfTheSamples() {
        // Far below the toe of the sRGB curve all is a line of slope 12.92.
        double[][] samples = samples(16, 1);
        double[][] dark = new double[16][3];
        for (int i = 0; i < 48; i++) {
            dark[i / 3][i % 3] = samples[i / 3][i % 3] / (1 << 20);
        }
        double scale = Math.pow(12.92 / (1 << 20), 2);
        FilmTile display = tile(samples, DisplayCurve.NONE);
        FilmTile light = tile(dark, DisplayCurve.SRGB);
        assertEquals(scale * display.halves(0, 0), light.halves(0, 0), 1e-5 * scale);
        assertEquals(scale * display.quarters(0, 0), light.quarters(0, 0), 1e-5 * scale);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 7, 9, 13, 100})
    void inTheMeanUnequalQuartersTellWhatEqualOnesWould(int n) {
        double halves = 0;
        double quarters = 0;
        int pixels = 40_000;
        Random random = new Random(n);
        double[] means = new double[QuarterMeans.PER_PIXEL];
        float[] rounded = new float[QuarterMeans.PER_PIXEL];
        for (int i = 0; i < pixels; i++) {
            double[] sums = new double[QuarterMeans.PER_PIXEL];
            for (int s = 0; s < n; s++) {
                int q = 0;
                while (TilePasses.firstSample(n, q + 1, 4) <= s) {
                    q++;
                }
                for (int c = 0; c < 3; c++) {
                    sums[3 * q + c] += 1e-4 + 1e-5 * random.nextGaussian();
                }
            }
            QuarterMeans.of(sums, n, rounded, 0);
            for (int k = 0; k < means.length; k++) {
                means[k] = rounded[k];
            }
            halves += QuarterMeans.halves(DisplayCurve.SRGB, means, n) / pixels;
            quarters += QuarterMeans.quarters(DisplayCurve.SRGB, means, n) / pixels;
        }
        double variance = 12.92e-5 * 12.92e-5 / n;
        assertEquals(variance, halves, 0.03 * variance);
        assertEquals(2 * variance, quarters, 0.06 * variance);
    }

    @Test
    void passesGiveTheSameBytesAsOneWholeInAnyOrder() {
        double[][] samples = samples(64, 5);
        FilmTile whole = tile(samples, CURVE);
        List<Integer> order = new ArrayList<>(List.of(0, 1, 2, 3, 4, 5, 6, 7));
        float[] first = null;
        for (int turn = 0; turn < 4; turn++) {
            Collections.shuffle(order, new Random(turn));
            TilePasses passes = new TilePasses(0, 0, 1, 1, 8);
            for (int pass : order) {
                FilmTile part = new FilmTile(0, 0, 1, 1, CURVE);
                for (int s = 8 * pass; s < 8 * pass + 8; s++) {
                    part.add(0, 0, samples[s][0], samples[s][1], samples[s][2]);
                }
                passes.add(pass, part);
            }
            FilmTile sum = new FilmTile(0, 0, 1, 1, CURVE);
            passes.into(sum);
            float[] told = {sum.halves(0, 0), sum.quarters(0, 0), (float) sum.mean(0, 0, 1)};
            first = turn == 0 ? told : first;
            assertArrayEquals(first, told);
            assertEquals(whole.halves(0, 0), sum.halves(0, 0), 1e-6 * whole.halves(0, 0));
            assertEquals(whole.quarters(0, 0), sum.quarters(0, 0), 1e-6 * whole.quarters(0, 0));
        }
    }

    @Test
    void aSampleThatIsNoNumberIsCountedAndLeftOut() {
        double[][] samples = samples(8, 6);
        samples[2][1] = Double.NaN;
        samples[5][0] = Double.POSITIVE_INFINITY;
        FilmTile tile = tile(samples, CURVE);
        assertEquals(2, tile.lostSamples());
        assertEquals(8, tile.count(0, 0));
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int s = 0; s < 8; s++) {
                sum += s == 2 || s == 5 ? 0 : samples[s][c] / 8;
            }
            assertEquals(sum, tile.mean(0, 0, c), 1e-12);
        }
        Film film = new Film(0, 0, 1, 1, CURVE);
        film.put(tile);
        assertEquals(2, film.lostSamples());
        assertTrue(film.error().rmse() < 1);
    }

    @Test
    void displayReferredTilesTakeEveryNumber() {
        FilmTile tile = new FilmTile(0, 0, 1, 1);
        tile.add(0, 0, Double.NaN, 0, 0);
        assertEquals(0, tile.lostSamples());
        assertTrue(Double.isNaN(tile.mean(0, 0, 0)));
    }

    @Test
    void filmsOfOtherPixelsAreNotAdded() {
        Film film = new Film(0, 0, 2, 2, CURVE);
        assertThrows(
                IllegalArgumentException.class,
                () -> film.plus(new SplatFilm(0, 0, 2, 1, 4, new SplatScale(30), CURVE)));
        assertThrows(
                IllegalArgumentException.class,
                () -> film.plus(new SplatFilm(0, 0, 2, 2, 4, new SplatScale(30), DisplayCurve.NONE)));
        assertThrows(IllegalArgumentException.class, () -> new Film(0, 0, 2, 2)
                .plus(new SplatFilm(0, 0, 2, 2, 4, new SplatScale(30), CURVE)));
    }
}

package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;
import enlightenment.sampling.Hash;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SplatFilmTest {
    private static final int WIDTH = 20;
    private static final int HEIGHT = 10;
    private static final int UNITS = 11;
    private static final int PATHS = 500;
    private static final SplatScale SCALE = SplatScale.of(0.5, UNITS * PATHS, WIDTH * HEIGHT);

    private static SplatFilm film() {
        return new SplatFilm(0, 0, WIDTH, HEIGHT, WIDTH * HEIGHT, SCALE, DisplayCurve.SRGB);
    }

    /** Path p reaches a point with a colour; both are functions of p alone. */
    private static SplatSums paths(long first, int count) {
        SplatBatch batch = new SplatBatch(0, 0, WIDTH, HEIGHT, SCALE);
        batch.begin(count);
        for (long p = first; p < first + count; p++) {
            double u = Hash.unit(Hash.of(p, 1));
            batch.add(WIDTH * u * u, HEIGHT * Hash.unit(Hash.of(p, 2)), Hash.unit(Hash.of(p, 3)), u, 1e-9);
        }
        return batch.sums();
    }

    private static SplatSums unit(int unit) {
        return paths((long) unit * PATHS, PATHS);
    }

    private static SplatFilm complete() {
        SplatFilm film = film();
        for (int u = 0; u < UNITS; u++) {
            assertTrue(film.add(u, unit(u)));
        }
        return film;
    }

    private static void checkSame(SplatFilm expected, SplatFilm actual) {
        assertArrayEquals(expected.toImage().toArray(), actual.toImage().toArray());
        assertEquals(expected.paths(), actual.paths());
        assertEquals(expected.units(), actual.units());
        assertEquals(expected.error().rmse(), actual.error().rmse());
        assertEquals(expected.error().low(), actual.error().low());
        assertEquals(expected.error().high(), actual.error().high());
        assertArrayEquals(expected.error().variances(), actual.error().variances());
    }

    @Test
    void unitsMayComeInAnyOrderMoreThanOnceAndGoAgain() {
        SplatFilm expected = complete();
        Random random = new Random(1);
        for (int run = 0; run < 20; run++) {
            SplatFilm film = film();
            List<Integer> order = new ArrayList<>();
            for (int k = 0; k < 2 * UNITS; k++) {
                order.add(k % UNITS);
            }
            Collections.shuffle(order, random);
            for (int u : order) {
                film.add(u, unit(u));
                int out = random.nextInt(UNITS);
                film.remove(out, unit(out));
            }
            for (int u = 0; u < UNITS; u++) {
                film.add(u, unit(u));
            }
            checkSame(expected, film);
        }
    }

    @Test
    void unitsMayComeFromManyThreads() {
        SplatFilm film = film();
        IntStream.range(0, 5 * UNITS).parallel().forEach(k -> film.add(k % UNITS, unit(k % UNITS)));
        checkSame(complete(), film);
    }

    @Test
    void thePictureDoesNotDependOnHowPathsAreCutIntoUnits() {
        SplatFilm film = film();
        long first = 0;
        for (int u = 0; first < (long) UNITS * PATHS; u++) {
            int count = (int) Math.min(1 + 37 * u, (long) UNITS * PATHS - first);
            film.add(u, paths(first, count));
            first += count;
        }
        assertEquals(complete().paths(), film.paths());
        assertArrayEquals(complete().toImage().toArray(), film.toImage().toArray());
    }

    @Test
    void aUnitThatIsInIsNotAddedAgainAndOneThatIsNotIsNotTakenOut() {
        SplatFilm film = complete();
        assertFalse(film.add(3, unit(3)));
        assertFalse(film.remove(UNITS, unit(3)));
        checkSame(complete(), film);
        assertTrue(film.remove(3, unit(3)));
        assertEquals(UNITS - 1, film.units());
        assertEquals((UNITS - 1) * PATHS, film.paths());
        assertThrows(IllegalArgumentException.class, () -> film.remove(7, paths(0, 100 * PATHS)));
        assertTrue(film.add(3, unit(3)));
        checkSame(complete(), film);
    }

    @Test
    void aPixelThatIsTooBrightFailsWithItsPlaceAndChangesNothing() {
        SplatFilm film = new SplatFilm(30, 40, 4, 4, 16, new SplatScale(0), DisplayCurve.SRGB);
        SplatSums most = new SplatSums(new int[] {2, 9}, new long[] {1, 1, 1, 0, Long.MAX_VALUE, 0}, 1);
        SplatSums more = new SplatSums(new int[] {2, 9}, new long[] {5, 5, 5, 0, 1, 0}, 1);
        film.add(0, most);
        // The sum of all groups may be larger than a long.
        film.add(1, most);
        film.add(2, most);
        float[] before = film.toImage().toArray();
        assertEquals((float) (3 * 0x1p63 * 16 / 3), film.toImage().component(1, 2, 1));
        String message =
                assertThrows(ArithmeticException.class, () -> film.add(4, more)).getMessage();
        assertTrue(message.startsWith("pixel 31,42 is more than 2^30 times as bright"), message);
        assertArrayEquals(before, film.toImage().toArray());
        assertEquals(3, film.units());
        assertTrue(film.remove(0, most));
        assertTrue(film.add(4, more));
    }

    @Test
    void withoutPathsAllIsBlackAndWithoutErrorToTellOf() {
        SplatFilm film = film();
        assertArrayEquals(new float[3 * WIDTH * HEIGHT], film.toImage().toArray());
        assertEquals(0, film.error().rmse());
    }

    @Test
    void aPictureHoldsWhatItsFilmHolds() {
        for (DisplayCurve curve :
                List.of(DisplayCurve.NONE, DisplayCurve.SRGB, DisplayCurve.of(1.5, DisplayCurve.Tone.FILMIC))) {
            assertEquals(curve, new Film(0, 0, 2, 2, curve).toImage().curve());
            SplatFilm film = new SplatFilm(0, 0, 2, 2, 4, SCALE, curve);
            assertEquals(curve.encoding(), film.encoding());
            assertEquals(curve, film.toImage().curve());
        }
        assertEquals(Color.Encoding.DISPLAY, new Film(0, 0, 2, 2).encoding());
    }

    @Test
    void aSingleGroupIsWorthNoMoreThanItsOwnBrightness() {
        SplatFilm film = film();
        film.add(4, unit(4));
        film.add(8, unit(8));
        double sum = 0;
        for (float v : film.toImage().toArray()) {
            sum += (double) v * v;
        }
        assertEquals(Math.sqrt(sum / (3 * WIDTH * HEIGHT)), film.error().rmse(), 1e-6);
        assertTrue(film.error().high() > film.error().rmse());
    }

    /** A quarter of each pixel's neighbours, in a crop: the same values. */
    @Test
    void aCropHasThePixelsOfTheWhole() {
        SplatFilm whole = complete();
        SplatFilm crop = new SplatFilm(3, 4, 5, 6, WIDTH * HEIGHT, SCALE, DisplayCurve.SRGB);
        SplatBatch batch = new SplatBatch(3, 4, 5, 6, SCALE);
        for (int u = 0; u < UNITS; u++) {
            batch.begin(PATHS);
            for (long p = (long) u * PATHS; p < (u + 1L) * PATHS; p++) {
                double v = Hash.unit(Hash.of(p, 1));
                batch.add(WIDTH * v * v, HEIGHT * Hash.unit(Hash.of(p, 2)), Hash.unit(Hash.of(p, 3)), v, 1e-9);
            }
            crop.add(u, batch.sums());
        }
        for (int y = 4; y < 10; y++) {
            for (int x = 3; x < 8; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(whole.component(x, y, c), crop.component(x, y, c));
                }
            }
        }
    }

    /**
     * Ten thousand splats in each of three pixels, the darkest with 2^31 units: 0.29 units of deviation for each splat, 29 for all of
     * them, and six of that.
     */
    @ParameterizedTest
    @CsvSource({"1", "1e-7", "1e9"})
    void roundingToUnitsDoesNotShow(double brightness) {
        int n = 30_000;
        SplatScale scale = SplatScale.of(brightness, n, 3);
        SplatFilm film = new SplatFilm(0, 0, 3, 1, 3, scale, DisplayCurve.SRGB);
        SplatBatch batch = new SplatBatch(0, 0, 3, 1, scale);
        batch.begin(n);
        double[] exact = new double[3];
        for (int i = 0; i < n; i++) {
            double v = brightness * (i % 3 + Hash.unit(Hash.mix(i)));
            batch.add(i % 3, 0, v, 0, 0);
            exact[i % 3] += v;
        }
        film.add(0, batch.sums());
        for (int i = 0; i < 3; i++) {
            double pixel = exact[i] / n * 3;
            assertEquals(pixel, film.component(i, 0, 0), pixel * 174 * 0x1p-31);
        }
    }
}

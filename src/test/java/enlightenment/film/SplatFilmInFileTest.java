package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.nio.file.Path;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Splats that are kept in a file, against those in memory. */
class SplatFilmInFileTest {
    private static final int X = 5;
    private static final int Y = 3;
    private static final int WIDTH = 300;

    /** Two bands, and a part of one. */
    private static final int HEIGHT = 21;

    private static final int PIXELS = WIDTH * HEIGHT;
    private static final int BATCHES = 50;

    @TempDir
    private Path folder;

    private final Random random = new Random(1);
    private SplatFilm inMemory;
    private SplatFilmInFile inFile;

    @BeforeEach
    void films() {
        make(DisplayCurve.SRGB);
    }

    private void make(DisplayCurve curve) {
        SplatScale scale = new SplatScale(39);
        inMemory = new SplatFilm(X, Y, WIDTH, HEIGHT, 2 * PIXELS, scale, curve);
        inFile = new SplatFilmInFile(X, Y, WIDTH, HEIGHT, 2 * PIXELS, scale, curve, folder);
    }

    /** A batch that reaches about a half of the pixels. */
    private SplatSums batch() {
        int[] pixels =
                IntStream.range(0, PIXELS).filter(p -> random.nextBoolean()).toArray();
        long[] sums = random.longs(3L * pixels.length, -1L << 38, 1L << 41).toArray();
        return new SplatSums(pixels, sums, 1000 + random.nextInt(100));
    }

    private void add(int unit, SplatSums batch) {
        assertTrue(inMemory.add(unit, batch));
        assertTrue(inFile.add(unit, batch));
    }

    private void assertSame() {
        SplatLight expected = inMemory.light();
        SplatLight actual = inFile.light();
        assertEquals(expected.paths(), actual.paths());
        for (int i = 0; i < 3 * PIXELS; i++) {
            int column = X + i / 3 % WIDTH;
            int row = Y + i / 3 / WIDTH;
            assertEquals(expected.all(column, row, i % 3), actual.all(column, row, i % 3));
            for (int group = 0; group < Splats.GROUPS; group++) {
                assertEquals(expected.of(group, column, row, i % 3), actual.of(group, column, row, i % 3));
            }
        }
    }

    /** So many that what waits is added up several times: each band has a dozen times as much as may wait. */
    @Test
    void theSumsAreThoseInMemoryHoweverManyThereAre() {
        for (int unit = 0; unit < BATCHES; unit++) {
            add(unit, batch());
        }
        assertSame();
        assertEquals(BATCHES, inFile.units());
        assertFalse(inFile.add(7, batch()));
    }

    @Test
    void whatIsTakenOutLeavesNothing() {
        SplatSums wrong = batch();
        for (int unit = 0; unit < BATCHES; unit++) {
            add(unit, unit == 6 ? wrong : batch());
        }
        assertTrue(inMemory.remove(6, wrong));
        assertTrue(inFile.remove(6, wrong));
        assertFalse(inFile.remove(6, wrong));
        add(6, batch());
        assertSame();
    }

    @Test
    void aSumThatIsTooLargeNamesItsPixelWhenItIsRead() {
        SplatSums bright = new SplatSums(new int[] {11 * WIDTH + 7}, new long[] {0, Long.MAX_VALUE / 2 + 1, 0}, 1);
        inMemory.add(0, bright);
        inFile.add(0, bright);
        inFile.add(4, bright);
        String expected = assertThrows(ArithmeticException.class, () -> inMemory.add(4, bright))
                .getMessage();
        ArithmeticException e =
                assertThrows(ArithmeticException.class, () -> inFile.light().all(X, Y + 12, 0));
        assertEquals(expected, e.getMessage());
        assertTrue(expected.contains("12,14"), expected);
    }

    /** Pixels of none to six samples, in both films. */
    private void fill(TileFilm film) {
        Random pixels = new Random(2);
        film.put(X, Y, WIDTH, HEIGHT, (column, row, pixel) -> {
            pixel.clear();
            pixel.samples = pixels.nextInt(7);
            for (int i = 0; i < QuarterMeans.PER_PIXEL && pixel.samples > 0; i++) {
                pixel.ofQuarters[i] = pixels.nextFloat();
                pixel.means[i % 3] += pixel.ofQuarters[i] / 4;
            }
            if (pixel.samples == 1 || pixel.samples == 2 || film.encoding() == DisplayCurve.NONE.encoding()) {
                pixel.halves = pixels.nextFloat();
                pixel.quarters = pixels.nextFloat();
            }
        });
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theSumOfFilmsHasTheBitsOfThatInMemory(boolean isLinear) {
        DisplayCurve curve = isLinear ? DisplayCurve.SRGB : DisplayCurve.NONE;
        make(curve);
        Film tiles = new Film(X, Y, WIDTH, HEIGHT, curve);
        FilmInFile tilesInFile = new FilmInFile(X, Y, WIDTH, HEIGHT, curve, folder);
        fill(tiles);
        fill(tilesInFile);
        for (int units : new int[] {0, 3, BATCHES}) {
            for (int unit = inFile.units(); unit < units; unit++) {
                add(unit, batch());
            }
            Film expected = tiles.plus(inMemory);
            TileFilm actual = tilesInFile.plus(inFile);
            assertArrayEquals(expected.toImage().toArray(), actual.toImage().toArray());
            assertEquals(expected.cameraSamples(), actual.cameraSamples());
            ErrorEstimate error = expected.error();
            assertEquals(error.rmse(), actual.error().rmse());
            assertEquals(error.low(), actual.error().low());
            assertEquals(error.high(), actual.error().high());
            assertEquals(error.linear(), actual.error().linear());
            actual.release();
        }
    }
}

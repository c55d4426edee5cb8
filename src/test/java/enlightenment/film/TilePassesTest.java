package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Hash;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TilePassesTest {
    private static final int SIDE = 8;

    /** Samples of a pixel; some pixels have twice as many. */
    private static int count(int samples, int x, int y) {
        return (x + y) % 3 == 0 ? 2 * samples : samples;
    }

    /** A sample's colour; 0..1, a few very bright. */
    private static double sample(int x, int y, int s, int c) {
        long h = Hash.of(Hash.of(x, y), s, c);
        return Hash.unit(h) * ((h & 63) == 0 ? 1e4 : 1);
    }

    private static void add(FilmTile tile, int x, int y, int s) {
        tile.add(x, y, sample(x, y, s, 0), sample(x, y, s, 1), sample(x, y, s, 2));
    }

    private static FilmTile pass(int side, int samples, int pass, int passes) {
        FilmTile tile = new FilmTile(16, 24, side, side);
        for (int y = 24; y < 24 + side; y++) {
            for (int x = 16; x < 16 + side; x++) {
                int n = count(samples, x, y);
                int end = TilePasses.firstSample(n, pass + 1, passes);
                for (int s = TilePasses.firstSample(n, pass, passes); s < end; s++) {
                    add(tile, x, y, s);
                }
            }
        }
        return tile;
    }

    private static FilmTile undivided(int side, int samples) {
        FilmTile tile = new FilmTile(16, 24, side, side);
        SampleSpread spread = new SampleSpread();
        for (int y = 24; y < 24 + side; y++) {
            for (int x = 16; x < 16 + side; x++) {
                int n = count(samples, x, y);
                spread.begin(n);
                for (int s = 0; s < n; s++) {
                    add(tile, x, y, s);
                    spread.add(sample(x, y, s, 0), sample(x, y, s, 1), sample(x, y, s, 2));
                }
                tile.spread(x, y, spread);
            }
        }
        return tile;
    }

    private static FilmTile finished(TilePasses passes, int side) {
        FilmTile tile = new FilmTile(16, 24, side, side);
        passes.into(tile);
        return tile;
    }

    private static FilmTile merged(int side, int samples, int passes) {
        TilePasses all = new TilePasses(16, 24, side, side, passes);
        for (int p = 0; p < passes; p++) {
            assertTrue(all.add(p, pass(side, samples, p, passes)));
        }
        return finished(all, side);
    }

    /** All that becomes of a tile, as bits. */
    private static List<Long> bits(FilmTile tile) {
        List<Long> bits = new ArrayList<>();
        for (int y = tile.y; y < tile.y + tile.height; y++) {
            for (int x = tile.x; x < tile.x + tile.width; x++) {
                for (int c = 0; c < 3; c++) {
                    bits.add(Double.doubleToRawLongBits(tile.mean(x, y, c)));
                }
                bits.add((long) Float.floatToRawIntBits(tile.halves(x, y)));
                bits.add((long) Float.floatToRawIntBits(tile.quarters(x, y)));
                bits.add((long) tile.count(x, y));
            }
        }
        return bits;
    }

    @ParameterizedTest
    @CsvSource({"4, 4", "4, 7", "8, 8", "8, 21", "16, 100", "64, 64"})
    void everySampleBelongsToOnePassAndEveryQuarterToAQuarterOfThePasses(int passes, int samples) {
        assertEquals(0, TilePasses.firstSample(samples, 0, passes));
        assertEquals(samples, TilePasses.firstSample(samples, passes, passes));
        for (int p = 0; p < passes; p++) {
            assertTrue(
                    TilePasses.firstSample(samples, p + 1, passes) > TilePasses.firstSample(samples, p, passes),
                    "pass " + p + " is empty");
        }
        for (int q = 0; q < 4; q++) {
            // As SampleSpread has it: sample s belongs to the quarter ⌊4 s/n⌋.
            int first = TilePasses.firstSample(samples, q * passes / 4, passes);
            assertTrue(4 * first >= q * samples && 4 * (first - 1) < q * samples);
        }
    }

    @ParameterizedTest
    @CsvSource({"4, 4", "4, 6", "8, 9", "32, 100"})
    void passesTellTheSameErrorAsTheUndividedTile(int passes, int samples) {
        FilmTile whole = undivided(SIDE, samples);
        FilmTile merged = merged(SIDE, samples, passes);
        for (int y = 24; y < 24 + SIDE; y++) {
            for (int x = 16; x < 16 + SIDE; x++) {
                assertEquals(count(samples, x, y), merged.count(x, y));
                assertEquals(whole.halves(x, y), merged.halves(x, y), 2 * Math.ulp(whole.halves(x, y)));
                assertEquals(whole.quarters(x, y), merged.quarters(x, y), 2 * Math.ulp(whole.quarters(x, y)));
            }
        }
    }

    /** 120,000 pixels: doubles may differ in their last bit, the floats of a picture do not. */
    @Test
    void meansAgreeWithThoseOfTheUndividedTileToTheLastBitOfAFloat() {
        int side = 200;
        FilmTile whole = undivided(side, 16);
        FilmTile merged = merged(side, 16, 8);
        int doubles = 0;
        int floats = 0;
        for (int y = 24; y < 24 + side; y++) {
            for (int x = 16; x < 16 + side; x++) {
                for (int c = 0; c < 3; c++) {
                    double a = whole.mean(x, y, c);
                    double b = merged.mean(x, y, c);
                    doubles += a == b ? 0 : 1;
                    floats += (float) a == (float) b ? 0 : 1;
                    assertEquals(a, b, Math.ulp(a));
                }
            }
        }
        // A double's last bit moves a float across a rounding border in one of 2^29 cases.
        assertEquals(0, floats, doubles + " doubles differ");
        assertTrue(doubles < 100, doubles + " doubles differ");
    }

    @Test
    void aFireflyInOnePassDoesNotSwallowTheOthers() {
        int passes = 64;
        TilePasses all = new TilePasses(16, 24, 1, 1, passes);
        for (int p = 0; p < passes; p++) {
            FilmTile tile = new FilmTile(16, 24, 1, 1);
            for (int s = 0; s < 1000; s++) {
                tile.add(16, 24, p == 17 && s == 500 ? 1e12 : 1e-5, 0, 0);
            }
            all.add(p, tile);
        }
        double exact = (1e12 + 63_999 * 1e-5) / 64_000;
        assertEquals(exact, finished(all, 1).mean(16, 24, 0), Math.ulp(exact));
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 64})
    void passesMayComeInAnyOrderAndMoreThanOnce(int passes) {
        List<Long> expected = bits(merged(SIDE, passes, passes));
        Random random = new Random(passes);
        for (int run = 0; run < 10; run++) {
            List<Integer> order = new ArrayList<>();
            for (int p = 0; p < 2 * passes; p++) {
                order.add(p % passes);
            }
            Collections.shuffle(order, random);
            TilePasses all = new TilePasses(16, 24, SIDE, SIDE, passes);
            for (int p : order) {
                assertEquals(!all.has(p), all.add(p, pass(SIDE, passes, p, passes)));
                int levels = Integer.numberOfTrailingZeros(passes);
                assertTrue(all.kept() <= 4 + all.missing() * (levels - 2), all.kept() + " tiles are kept");
            }
            assertEquals(0, all.missing());
            assertEquals(expected, bits(finished(all, SIDE)));
            assertEquals(expected, bits(finished(all, SIDE)), "asked twice");
        }
    }

    @Test
    void whatIsTakenOutIsMadeAgain() {
        int passes = 32;
        List<Long> expected = bits(merged(SIDE, passes, passes));
        Random random = new Random(9);
        for (int run = 0; run < 20; run++) {
            TilePasses all = new TilePasses(16, 24, SIDE, SIDE, passes);
            for (int p = 0; p < passes; p++) {
                if (random.nextBoolean()) {
                    all.add(p, pass(SIDE, passes, p, passes));
                }
            }
            int present = passes - all.missing();
            int out = random.nextInt(passes);
            boolean was = all.has(out);
            List<Integer> lost = all.remove(out);
            assertEquals(was, lost.contains(out));
            assertEquals(present - lost.size(), passes - all.missing());
            lost.forEach(p -> assertFalse(all.has(p)));
            for (int p = passes - 1; p >= 0; p--) {
                all.add(p, pass(SIDE, passes, p, passes));
            }
            assertEquals(expected, bits(finished(all, SIDE)));
        }
    }

    @Test
    void anUnfinishedTileIsNotGiven() {
        TilePasses all = new TilePasses(16, 24, SIDE, SIDE, 4);
        all.add(2, pass(SIDE, 4, 2, 4));
        assertThrows(IllegalStateException.class, () -> finished(all, SIDE));
    }

    @Test
    void whatCannotBeAPassIsRefused() {
        TilePasses all = new TilePasses(16, 24, SIDE, SIDE, 4);
        FilmTile elsewhere = new FilmTile(8, 24, SIDE, SIDE);
        FilmTile empty = new FilmTile(16, 24, SIDE, SIDE);
        FilmTile differences = pass(SIDE, 4, 0, 4);
        differences.known(16, 24, 1, 1, 1, 0);
        for (FilmTile tile : List.of(elsewhere, empty, differences)) {
            assertThrows(IllegalArgumentException.class, () -> all.add(0, tile));
        }
        assertThrows(IllegalArgumentException.class, () -> all.add(4, pass(SIDE, 4, 0, 4)));
        assertEquals(4, all.missing());
    }

    @ParameterizedTest
    @CsvSource({"0, 2, 9", "0, 3, 9", "0, 12, 99", "0, 0, 9", "4, 4, 9", "-1, 4, 9", "0, 8, 7"})
    void otherNumbersOfPassesAreRefused(int pass, int passes, int fewest) {
        assertThrows(IllegalArgumentException.class, () -> TilePasses.check(pass, passes, fewest));
    }
}

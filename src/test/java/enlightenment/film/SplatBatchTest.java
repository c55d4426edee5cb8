package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Hash;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SplatBatchTest {
    private static final SplatScale UNIT = new SplatScale(0);

    private static SplatBatch batch() {
        return new SplatBatch(10, 20, 4, 3, UNIT);
    }

    @Test
    void contributionsToOnePixelAreAddedUp() {
        SplatBatch batch = batch();
        batch.begin(2);
        batch.add(13, 22, 1, 2, 3);
        batch.add(10.5, 20.5, 5, 0, 0);
        batch.add(13.999, 22.999, 10, 20, 30);
        SplatSums sums = batch.sums();
        assertEquals(2, sums.paths());
        assertArrayEquals(new int[] {0, 11}, sums.pixels);
        assertArrayEquals(new long[] {5, 0, 0, 11, 22, 33}, sums.sums);
    }

    @ParameterizedTest
    @CsvSource({
        "9.9999999, 21",
        "14, 21",
        "12, 19.999999",
        "12, 23",
        "-5, -5",
        "1e300, 21",
        "-Infinity, 21",
        "12, Infinity"
    })
    void whatFallsOutsideOfTheRectangleIsDropped(double x, double y) {
        SplatBatch batch = batch();
        batch.begin(7);
        batch.add(x, y, 1, 1, 1);
        assertEquals(0, batch.sums().size());
        assertEquals(7, batch.sums().paths(), "its path counts");
    }

    @Test
    void aPixelIsTheSameInEveryRectangle() {
        SplatBatch whole = new SplatBatch(0, 0, 64, 32, new SplatScale(40));
        SplatBatch crop = new SplatBatch(17, 5, 23, 11, new SplatScale(40));
        whole.begin(1000);
        crop.begin(1000);
        for (int i = 0; i < 10_000; i++) {
            double x = 64 * Hash.unit(Hash.of(i, 1));
            double y = 32 * Hash.unit(Hash.of(i, 2));
            double v = Hash.unit(Hash.of(i, 3));
            whole.add(x, y, v, 1, 0);
            crop.add(x, y, v, 1, 0);
        }
        SplatSums all = whole.sums();
        SplatSums part = crop.sums();
        int k = 0;
        for (int i = 0; i < all.pixels.length; i++) {
            int x = all.pixels[i] % 64 - 17;
            int y = all.pixels[i] / 64 - 5;
            if (x >= 0 && x < 23 && y >= 0 && y < 11) {
                assertEquals(23 * y + x, part.pixels[k]);
                assertEquals(all.sums[3 * i], part.sums[3 * k++]);
            }
        }
        assertEquals(part.size(), k);
    }

    /** So many that they are sorted and merged more than once, with pixels of one to three digits. */
    @ParameterizedTest
    @CsvSource({"1, 9000", "5, 20000", "3000, 50000", "5000000, 30000"})
    void sumsAreThoseOfAMap(int pixels, int splats) {
        SplatBatch batch = new SplatBatch(0, 0, pixels, 1, UNIT);
        for (int round = 0; round < 2; round++) {
            batch.begin(splats);
            Map<Integer, long[]> expected = new TreeMap<>();
            for (int i = 0; i < splats; i++) {
                int pixel = (int) (pixels * Hash.unit(Hash.of(i, round)));
                long v = Hash.of(i, 2) >>> 16;
                batch.add(pixel + 0.5, 0, v, 1, 0);
                long[] sum = expected.computeIfAbsent(pixel, k -> new long[2]);
                sum[0] += v;
                sum[1]++;
            }
            SplatSums sums = batch.sums();
            assertEquals(expected.size(), sums.size());
            int k = 0;
            for (Map.Entry<Integer, long[]> e : expected.entrySet()) {
                assertEquals(e.getKey(), sums.pixels[k]);
                assertEquals(e.getValue()[0], sums.sums[3 * k]);
                assertEquals(e.getValue()[1], sums.sums[3 * k + 1]);
                assertEquals(0, sums.sums[3 * k++ + 2]);
            }
        }
    }

    @Test
    void contributionsAreRoundedToTheNearestUnit() {
        SplatBatch batch = new SplatBatch(0, 0, 1, 1, new SplatScale(3));
        batch.begin(1);
        batch.add(0, 0, 0.3, 0.0624, 1);
        assertArrayEquals(new long[] {2, 0, 8}, batch.sums().sums);
    }

    @Test
    void whatIsLessThanHalfAUnitReachesNothing() {
        SplatBatch batch = batch();
        batch.begin(1);
        batch.add(11, 21, 0.4, 0, 0.1);
        assertEquals(0, batch.sums().size());
    }

    /** Powers of two: the scale, a contribution, its units. 2^1080 is no double. */
    @ParameterizedTest
    @CsvSource({"1080, -1064, 16", "1023, -1074, -51", "-1020, 1023, 3", "0, 61, 61"})
    void scalesBeyondTheRangeOfDoublesCountRight(int exponent, int contribution, int units) {
        SplatBatch batch = new SplatBatch(0, 0, 1, 1, new SplatScale(exponent));
        batch.begin(1);
        batch.add(0, 0, Math.scalb(1.0, contribution), 0, 0);
        assertArrayEquals(units < 0 ? new long[0] : new long[] {1L << units, 0, 0}, batch.sums().sums);
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 0, -Infinity, 0", "1, 1, 0, NaN, 0", "1, 1, 0, 0, Infinity", "NaN, 1, 0, 0, 0", "1, NaN, 0, 0, 0"
    })
    void whatCannotBeLightIsRefusedWithItsNumbers(double x, double y, double r, double g, double b) {
        SplatBatch batch = batch();
        batch.begin(1);
        ArithmeticException e = assertThrows(ArithmeticException.class, () -> batch.add(x, y, r, g, b));
        assertEquals("a path contributes " + r + "," + g + "," + b + " at " + x + "," + y, e.getMessage());
    }

    @Test
    void aSumThatIsTooLargeFailsWithThePixelUntilItBeginsAgain() {
        SplatBatch batch = batch();
        batch.begin(3);
        batch.add(12, 21, 0x1p62, 0, 0);
        batch.add(12, 21, 0x1p62, 0, 0);
        for (int i = 0; i < 2; i++) {
            String message =
                    assertThrows(ArithmeticException.class, batch::sums).getMessage();
            assertTrue(message.startsWith("pixel 12,21 is more than 2^30 times as bright"), message);
            batch.add(12, 21, 1, 1, 1);
        }
        batch.begin(1);
        batch.add(12, 21, 0x1p62, 0, 0);
        assertEquals(1L << 62, batch.sums().sums[0]);
    }

    /** Light of a single wavelength has more colour than any screen: bands may be negative. */
    @Test
    void negativeContributionsAreSubtracted() {
        SplatBatch batch = batch();
        batch.begin(2);
        batch.add(12, 21, -1, 3, 1);
        batch.add(12, 21, 1, -5, 0);
        long[] sums = batch.sums().sums;
        assertEquals(0, sums[0]);
        assertEquals(-2 * sums[2], sums[1]);
    }

    @Test
    void aNegativeSumThatIsTooLargeFailsToo() {
        SplatBatch batch = batch();
        batch.begin(3);
        for (int i = 0; i < 3; i++) {
            batch.add(12, 21, 0, -0x1p62, 0);
        }
        assertThrows(ArithmeticException.class, batch::sums);
        batch.begin(1);
        batch.add(10, 20, 0, -Double.MAX_VALUE, 0);
        assertThrows(ArithmeticException.class, batch::sums);
    }

    @Test
    void aSingleContributionMayBeTooLarge() {
        SplatBatch batch = batch();
        batch.begin(1);
        batch.add(10, 20, 0, Double.MAX_VALUE, 0);
        assertThrows(ArithmeticException.class, batch::sums);
    }
}

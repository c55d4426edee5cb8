package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SplatSumsTest {
    private static final int PIXELS = 1_000_000;

    private static SplatSums random(Random random, int size) {
        int[] pixels = random.ints(size, 0, PIXELS).distinct().sorted().toArray();
        long[] sums = new long[3 * pixels.length];
        for (int i = 0; i < sums.length; i++) {
            sums[i] = random.nextLong() >> random.nextInt(63);
        }
        for (int i = 0; i < pixels.length; i++) {
            sums[3 * i] |= 1;
        }
        return new SplatSums(pixels, sums, random.nextInt(1 << 20));
    }

    private static void checkSame(SplatSums expected, SplatSums actual) {
        assertArrayEquals(expected.pixels, actual.pixels);
        assertArrayEquals(expected.sums, actual.sums);
        assertEquals(expected.paths(), actual.paths());
    }

    @Test
    void bytesGiveBackWhatTheyWereMadeOf() {
        Random random = new Random(1);
        for (int run = 0; run < 50; run++) {
            SplatSums sums = random(random, run * run);
            byte[] bytes = sums.toBytes();
            assertEquals(Optional.empty(), SplatSums.problem(bytes, sums.paths(), PIXELS));
            checkSame(sums, SplatSums.of(bytes, PIXELS));
        }
        SplatSums extreme = new SplatSums(
                new int[] {0, Integer.MAX_VALUE - 1},
                new long[] {Long.MAX_VALUE, 0, Long.MIN_VALUE, 0, 0, 1},
                Long.MAX_VALUE);
        checkSame(extreme, SplatSums.of(extreme.toBytes(), Integer.MAX_VALUE));
    }

    @Test
    void theBytesAreTheDocumentedOnes() {
        SplatSums sums = new SplatSums(new int[] {2, 130}, new long[] {150, 0, -1, -64, 64, -3}, 7);
        byte[] expected = {7, 2, 3, (byte) 0xac, 2, 0, 1, (byte) 0x80, 1, 127, (byte) 0x80, 1, 5};
        assertArrayEquals(expected, sums.toBytes());
    }

    @ParameterizedTest
    @CsvSource({
        "'', it ends in the middle",
        "'7', it ends in the middle",
        "'8 0', it has 8 paths instead of 7",
        "'7 0 0', 1 bytes too many",
        "'7 1', 1 pixels in 0 bytes",
        "'7 127 1 1 1 1', 127 pixels in 4 bytes",
        "'7 2 1 1 1 1 1 1 1', 2 pixels in 7 bytes",
        "'7 1 0 1 1 1', a pixel lies 0 after pixel -1",
        "'7 1 11 1 1 1', a pixel lies 11 after pixel -1",
        "'7 2 9 1 1 1 2 1 1 1', a pixel lies 2 after pixel 8",
        "'7 1 1 0 0 0', pixel 0 was not reached",
        "'7 1 1 -127 0 1 1', a number with leading zeros",
        "'7 1 1 -1 -1 -1 -1 -1 -1 -1 -1 -1 2 1 1', a number is too large",
        "'7 1 1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 1 1', a number is too large",
        "'-1 -1 -1 -1 -1 -1 -1 -1 -1 1 0', a number is too large"
    })
    void bytesThatCannotBeSumsAreToldApart(String numbers, String problem) {
        String[] parts = numbers.isEmpty() ? new String[0] : numbers.split(" ");
        byte[] bytes = new byte[parts.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) Integer.parseInt(parts[i]);
        }
        assertEquals(Optional.of(problem), SplatSums.problem(bytes, 7, 10));
    }

    /** There is one form of everything: bytes that are changed are refused, or are those of something else. */
    @Test
    void whateverTheBytesAreTheyAreRefusedOrComeBackAsTheyWere() {
        Random random = new Random(2);
        int refused = 0;
        for (int run = 0; run < 20_000; run++) {
            SplatSums sums = random(random, 5);
            byte[] bytes = sums.toBytes();
            for (int k = random.nextInt(3); k >= 0; k--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
            }
            byte[] changed = random.nextBoolean() ? bytes : Arrays.copyOf(bytes, random.nextInt(bytes.length + 3));
            try {
                assertArrayEquals(changed, SplatSums.of(changed, PIXELS).toBytes());
            } catch (IllegalArgumentException e) {
                refused++;
            }
        }
        assertTrue(refused > 1000 && refused < 20_000, refused + " were refused");
    }
}

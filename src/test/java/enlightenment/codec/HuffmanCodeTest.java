package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class HuffmanCodeTest {
    /** The words of a complete code fill the code space exactly. */
    private static void assertComplete(HuffmanCode code, int limit) {
        long claimed = 0;
        for (int length : code.lengths) {
            assertTrue(length >= 0 && length <= limit, "length " + length);
            claimed += length == 0 ? 0 : 1L << (limit - length);
        }
        assertEquals(1L << limit, claimed);
    }

    @Test
    void theExampleOfRfc1951IsReproduced() {
        // RFC 1951, 3.2.2: lengths (3,3,3,3,3,2,4,4) give 010, 011, 100, 101, 110, 00, 1110, 1111; ours are reversed.
        HuffmanCode code = HuffmanCode.ofLengths(3, 3, 3, 3, 3, 2, 4, 4);
        assertArrayEquals(new int[] {0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111}, code.words);
    }

    @Test
    void powersOfTwoGetTheirExactLengths() {
        HuffmanCode code = HuffmanCode.ofCounts(new int[] {8, 0, 4, 2, 1, 1}, 15);
        assertArrayEquals(new int[] {1, 0, 2, 3, 4, 4}, code.lengths);
    }

    @Test
    void oneSymbolOrNoneStillMakesACompleteCode() {
        assertArrayEquals(new int[] {0, 0, 0}, without(HuffmanCode.ofCounts(new int[] {0, 0, 0}, 7).lengths, 1));
        assertComplete(HuffmanCode.ofCounts(new int[30], 15), 15);
        HuffmanCode one = HuffmanCode.ofCounts(new int[] {0, 0, 9, 0}, 15);
        assertEquals(1, one.lengths[2]);
        assertComplete(one, 15);
    }

    private static int[] without(int[] lengths, int expected) {
        int[] rest = lengths.clone();
        int removed = 0;
        for (int i = 0; i < rest.length; i++) {
            if (rest[i] == expected) {
                rest[i] = 0;
                removed++;
            }
        }
        assertEquals(2, removed);
        return rest;
    }

    @Test
    void fibonacciCountsAreShortenedToTheLimit() {
        int[] counts = new int[40];
        counts[0] = 1;
        counts[1] = 1;
        for (int i = 2; i < counts.length; i++) {
            counts[i] = counts[i - 1] + counts[i - 2];
        }
        for (int limit : new int[] {6, 7, 9, 15}) {
            assertComplete(HuffmanCode.ofCounts(counts, limit), limit);
        }
    }

    @Test
    void randomCountsGiveCompleteCodesNotMuchLongerThanTheEntropy() {
        Random random = new Random(1);
        for (int round = 0; round < 200; round++) {
            int[] counts = new int[286];
            double total = 0;
            for (int i = 0; i < counts.length; i++) {
                counts[i] = random.nextInt(4) == 0 ? 0 : 1 << random.nextInt(14);
                total += counts[i];
            }
            HuffmanCode code = HuffmanCode.ofCounts(counts, 15);
            assertComplete(code, 15);
            double entropy = 0;
            double bits = 0;
            for (int i = 0; i < counts.length; i++) {
                bits += counts[i] * code.lengths[i];
                entropy += counts[i] == 0 ? 0 : counts[i] * Math.log(total / counts[i]) / Math.log(2);
            }
            // Huffman's bound: less than one bit per symbol above the entropy.
            assertTrue(bits >= entropy - 1e-6 && bits < entropy + total, bits + " bits, entropy " + entropy);
        }
    }
}

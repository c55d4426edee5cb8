package enlightenment.codec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HalfTest {
    private static final int INFINITY = 0x7c00;

    @Test
    void halvesAreReadAsTheStandardSays() {
        assertEquals(1f, Half.toFloat((short) 0x3c00));
        assertEquals(-2f, Half.toFloat((short) 0xc000));
        assertEquals(65504f, Half.toFloat((short) 0x7bff));
        assertEquals((float) Math.pow(2, -14), Half.toFloat((short) 0x0400));
        assertEquals((float) Math.pow(2, -24), Half.toFloat((short) 0x0001));
        assertEquals(Float.POSITIVE_INFINITY, Half.toFloat((short) 0x7c00));
        assertTrue(Float.isNaN(Half.toFloat((short) 0x7e00)));
        assertEquals(0f, Half.toFloat((short) 0));
    }

    @Test
    void everyHalfComesBack() {
        for (int bits = 0; bits < 1 << 16; bits++) {
            if ((bits & 0x7fff) <= INFINITY) {
                assertEquals((short) bits, Half.of(Half.toFloat((short) bits)));
            }
        }
    }

    /** Positive halves are ordered as their bits, so the two next to a float are found by halving. */
    @Test
    void aFloatBecomesTheNearestHalfAndTheEvenOneOfTwo() {
        SplittableRandom random = new SplittableRandom(3);
        int ties = 0;
        for (int i = 0; i < 200_000; i++) {
            int below = random.nextInt(INFINITY - 1);
            double low = Half.toFloat((short) below);
            double high = Half.toFloat((short) (below + 1));
            boolean isTie = i % 4 == 0;
            float value = (float) (isTie ? (low + high) / 2 : low + random.nextDouble() * (high - low));
            int even = (below & 1) == 0 ? below : below + 1;
            double toLow = value - low;
            double toHigh = high - value;
            int expected = toLow < toHigh ? below : toLow > toHigh ? below + 1 : even;
            ties += toLow == toHigh ? 1 : 0;
            assertEquals((short) expected, Half.of(value), () -> value + "");
            assertEquals((short) (expected | 0x8000), Half.of(-value), () -> value + "");
        }
        assertTrue(ties >= 50_000);
    }

    @Test
    void whatIsFiniteStaysFinite() {
        for (float value : new float[] {65519, 65520, 1e6f, Float.MAX_VALUE}) {
            assertEquals(Half.MAX, Half.toFloat(Half.of(value)));
            assertEquals(-Half.MAX, Half.toFloat(Half.of(-value)));
        }
        assertEquals(Float.POSITIVE_INFINITY, Half.toFloat(Half.of(Float.POSITIVE_INFINITY)));
        assertEquals(0f, Half.toFloat(Half.of(Float.MIN_VALUE)));
    }
}

package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.sampling.Hash;
import java.math.BigDecimal;
import org.junit.jupiter.api.Test;

class DecimalsTest {
    /** How far off the nearest multiple is at most, and what one division may add. */
    private static final BigDecimal HALF = new BigDecimal("0.5002");

    @Test
    void aMultipleOfAPowerOfTenIsNearAndWhole() {
        for (int i = 0; i < 2000; i++) {
            long bits = Hash.of(7, i);
            double v = Math.scalb((double) bits, (int) (Hash.of(8, i) % 200));
            int k = (int) (Hash.of(9, i) % 40);
            BigDecimal step = BigDecimal.ONE.scaleByPowerOfTen(k);
            BigDecimal near = Decimals.near(v, k);
            assertEquals(0, near.remainder(step).signum(), v + " by " + k);
            BigDecimal off = near.subtract(new BigDecimal(v)).abs();
            assertTrue(off.compareTo(HALF.multiply(step)) <= 0, v + " by " + k);
        }
    }

    @Test
    void whatIsAMultipleStays() {
        assertEquals(0, new BigDecimal("12.5").compareTo(Decimals.near(12.5, -3)));
        assertEquals(0, new BigDecimal("-3e20").compareTo(Decimals.near(-3e20, 19)));
        assertEquals(0, BigDecimal.ZERO.compareTo(Decimals.near(-0.0, -22)));
        assertEquals(0, new BigDecimal(Double.MIN_VALUE).compareTo(Decimals.near(Double.MIN_VALUE, -1100)));
        assertEquals(0, new BigDecimal(Double.MAX_VALUE).compareTo(Decimals.near(Double.MAX_VALUE, -2)));
    }
}

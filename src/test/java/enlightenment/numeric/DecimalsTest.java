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

    @Test
    void theNearestDoubleOfAnExactOneIsItself() {
        for (int i = 0; i < 2000; i++) {
            double v = Math.scalb((double) Hash.of(10, i), -(int) (Hash.of(11, i) & 63) - 64);
            assertEquals(v, Decimals.nearest(new BigDecimal(v)));
        }
    }

    @Test
    void theMiddleBetweenTwoDoublesGoesToTheEvenOneAndALittleMoreToTheUpperOne() {
        BigDecimal little = BigDecimal.ONE.movePointLeft(120);
        for (int i = 0; i < 2000; i++) {
            double low = Math.scalb((double) (Hash.of(12, i) >>> 11 | 1L << 52), -53);
            double high = Math.nextUp(low);
            BigDecimal middle = new BigDecimal(low).add(new BigDecimal(high)).divide(BigDecimal.valueOf(2));
            boolean isLowEven = (Double.doubleToLongBits(low) & 1) == 0;
            assertEquals(isLowEven ? low : high, Decimals.nearest(middle));
            assertEquals(high, Decimals.nearest(middle.add(little)));
            assertEquals(low, Decimals.nearest(middle.subtract(little)));
            assertEquals(-low, Decimals.nearest(middle.subtract(little).negate()));
        }
    }

    @Test
    void theNearestDoubleIsFoundAtTheEndsOfTheRange() {
        assertEquals(0, Decimals.nearest(new BigDecimal("0.000")));
        assertEquals(Double.POSITIVE_INFINITY, Decimals.nearest(new BigDecimal("1e400").setScale(3)));
        assertEquals(Double.MAX_VALUE, Decimals.nearest(new BigDecimal(Double.MAX_VALUE).setScale(5)));
        assertEquals(Double.MIN_VALUE, Decimals.nearest(new BigDecimal(Double.MIN_VALUE)));
        assertEquals(1e-127, Decimals.nearest(new BigDecimal("1e-127")));
    }
}

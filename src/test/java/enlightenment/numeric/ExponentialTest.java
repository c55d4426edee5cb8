package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ExponentialTest {
    private static final MathContext DIGITS = new MathContext(60);

    /** By the series of x/2¹¹, squared eleven times. */
    private static BigDecimal exact(double x) {
        BigDecimal r = new BigDecimal(x).divide(new BigDecimal(1 << 11), DIGITS);
        BigDecimal sum = BigDecimal.ONE;
        BigDecimal term = BigDecimal.ONE;
        for (int n = 1; n < 40; n++) {
            term = term.multiply(r, DIGITS).divide(new BigDecimal(n), DIGITS);
            sum = sum.add(term, DIGITS);
        }
        for (int k = 0; k < 11; k++) {
            sum = sum.multiply(sum, DIGITS);
        }
        return sum;
    }

    private static double error(double x) {
        double found = Exponential.exp(x);
        BigDecimal difference = new BigDecimal(found).subtract(exact(x)).abs();
        return difference.divide(new BigDecimal(Math.ulp(found)), DIGITS).doubleValue();
    }

    @Test
    void theErrorIsBelowOneUnitInTheLastPlace() {
        SplittableRandom random = new SplittableRandom(1);
        double worst = 0;
        for (int k = 0; k < 20_000; k++) {
            double x =
                    switch (k % 4) {
                        case 0 -> random.nextDouble(-745, 709.7);
                        case 1 -> random.nextDouble(-5, 5);
                        // Results that are no normal numbers.
                        case 2 -> random.nextDouble(-745.1, -708);
                        // Next to where the whole power of two changes.
                        default -> (random.nextInt(-1000, 1000) + 0.5) * Math.log(2) + random.nextDouble(-1e-14, 1e-14);
                    };
            worst = Math.max(worst, error(x));
        }
        assertTrue(worst < 1, "" + worst);
        // It is rounded: no error is below half a unit everywhere but by chance.
        assertTrue(worst > 0.5, "" + worst);
    }

    @Test
    void limitsAreExact() {
        assertEquals(1, Exponential.exp(0));
        assertEquals(1, Exponential.exp(-0.0));
        assertEquals(1, Exponential.exp(1e-300));
        assertEquals(0, Exponential.exp(Double.NEGATIVE_INFINITY));
        assertEquals(0, Exponential.exp(-Double.MAX_VALUE));
        assertEquals(0, Exponential.exp(-745.2));
        assertEquals(Double.MIN_VALUE, Exponential.exp(-745));
        assertEquals(Double.POSITIVE_INFINITY, Exponential.exp(709.8));
        assertEquals(Double.POSITIVE_INFINITY, Exponential.exp(Double.POSITIVE_INFINITY));
        assertTrue(Double.isFinite(Exponential.exp(709.78)));
        assertEquals(Double.NaN, Exponential.exp(Double.NaN));
    }

    /** Light that goes through more of a medium is never brighter. */
    @Test
    void itNeverDecreases() {
        for (double start : new double[] {-700, -20, -1, -0.34657359027997264, 0, 0.34657359027997264, 1}) {
            double x = start;
            for (int k = 0; k < 2000; k++) {
                double next = Math.nextUp(x);
                assertTrue(Exponential.exp(x) <= Exponential.exp(next), "at " + x);
                x = next;
            }
        }
    }

    /** {@link StrictMath} itself is right to one unit. */
    @Test
    void logarithmsAreRightToTwoUnits() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 200_000; i++) {
            double u = random.nextDouble();
            // Every second one is close to 1, where the logarithm is small.
            double x = i % 2 == 0 ? Math.scalb(1 + u, i % 2040 - 1022) : 1 + (u - 0.5) * Math.scalb(1.0, -i % 50);
            double exact = StrictMath.log(x);
            assertEquals(exact, Exponential.log(x), 2 * Math.ulp(exact), "ln " + x);
        }
        for (double x : new double[] {1, 2, Double.MIN_VALUE, Double.MAX_VALUE}) {
            assertEquals(StrictMath.log(x), Exponential.log(x), 2 * Math.ulp(StrictMath.log(x)), "ln " + x);
        }
        assertEquals(Double.NEGATIVE_INFINITY, Exponential.log(0));
        assertEquals(Double.POSITIVE_INFINITY, Exponential.log(Double.POSITIVE_INFINITY));
        assertEquals(Double.NaN, Exponential.log(-1));
        assertEquals(Double.NaN, Exponential.log(Double.NaN));
    }
}

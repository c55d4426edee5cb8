package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ExponentialTest {
    /** {@link StrictMath} itself is right to one unit. */
    private static final int UNITS = 2;

    @Test
    void powersOfEAreRightToTwoUnits() {
        for (int i = 0; i < 200_000; i++) {
            double x = (2 * Hash.unit(Hash.of(1, i)) - 1) * Math.scalb(1.0, 10 - i % 40);
            double exact = StrictMath.exp(x);
            assertEquals(exact, Exponential.exp(x), UNITS * Math.ulp(exact), "exp " + x);
        }
        for (double x : new double[] {0, -0.0, 700, -700, 701, -745, -1e300}) {
            assertEquals(StrictMath.exp(x), Exponential.exp(x), UNITS * Math.ulp(StrictMath.exp(x)), "exp " + x);
        }
        assertEquals(Double.NaN, Exponential.exp(Double.NaN));
        assertEquals(0, Exponential.exp(Double.NEGATIVE_INFINITY));
        assertEquals(Double.POSITIVE_INFINITY, Exponential.exp(1e300));
    }

    @Test
    void logarithmsAreRightToTwoUnits() {
        for (int i = 0; i < 200_000; i++) {
            double u = Hash.unit(Hash.of(2, i));
            // Every second one is close to 1, where the logarithm is small.
            double x = i % 2 == 0 ? Math.scalb(1 + u, i % 2040 - 1022) : 1 + (u - 0.5) * Math.scalb(1.0, -i % 50);
            double exact = StrictMath.log(x);
            assertEquals(exact, Exponential.log(x), UNITS * Math.ulp(exact), "ln " + x);
        }
        for (double x : new double[] {1, 2, Double.MIN_VALUE, Double.MAX_VALUE}) {
            assertEquals(StrictMath.log(x), Exponential.log(x), UNITS * Math.ulp(StrictMath.log(x)), "ln " + x);
        }
        assertEquals(Double.NEGATIVE_INFINITY, Exponential.log(0));
        assertEquals(Double.POSITIVE_INFINITY, Exponential.log(Double.POSITIVE_INFINITY));
        assertEquals(Double.NaN, Exponential.log(-1));
        assertEquals(Double.NaN, Exponential.log(Double.NaN));
    }
}

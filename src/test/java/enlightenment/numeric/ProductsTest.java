package enlightenment.numeric;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Sums of products against decimal arithmetic, in which products and sums of doubles are exact. */
class ProductsTest {
    private static final int COUNT = 20_000;
    private static final double U = Scale.UNIT_ROUNDOFF;

    private final SplittableRandom random = new SplittableRandom(1);

    /** A number of any sign, with a random exponent in −range..range. */
    private double number(int range) {
        double fraction = 1 + random.nextDouble();
        return Math.scalb(random.nextBoolean() ? fraction : -fraction, random.nextInt(-range, range + 1));
    }

    /** A number that differs from v in its last digits, or in more of them, or not at all. */
    private double near(double v) {
        return v * (1 + Math.scalb(random.nextInt(-2, 3), -random.nextInt(1, 53)));
    }

    private static BigDecimal product(double... factors) {
        BigDecimal p = BigDecimal.ONE;
        for (double f : factors) {
            p = p.multiply(new BigDecimal(f));
        }
        return p;
    }

    private static double error(double computed, BigDecimal exact) {
        return new BigDecimal(computed).subtract(exact).abs().doubleValue();
    }

    @Test
    void aDifferenceOfProductsIsWithinOneAndAHalfUnitsAndKeepsItsSign() {
        int cancelled = 0;
        for (int i = 0; i < COUNT; i++) {
            double a = number(60);
            double b = number(60);
            // Every second pair of products almost cancels.
            double c = i % 2 == 0 ? near(a) : number(60);
            double d = i % 2 == 0 ? near(b) : number(60);
            BigDecimal exact = product(a, b).subtract(product(c, d));
            double computed = Products.difference(a, b, c, d);
            String what = a + "·" + b + " − " + c + "·" + d;
            assertTrue(error(computed, exact) <= 1.5 * Math.ulp(computed), what);
            assertEquals(exact.signum(), (int) Math.signum(computed), what);
            double sum = Products.sum(a, b, -c, d);
            assertTrue(error(sum, exact) <= 1.5 * Math.ulp(sum), what);
            assertEquals(exact.signum(), (int) Math.signum(sum), what);
            cancelled += Math.abs(computed) < 1e-9 * Math.abs(a * b) ? 1 : 0;
        }
        assertTrue(cancelled > COUNT / 20, cancelled + " cancelled");
    }

    @Test
    void dotProductsAreWithinTheirBounds() {
        int cancelled = 0;
        for (int i = 0; i < COUNT; i++) {
            double[] a = {number(20), number(20), number(20)};
            double[] b = {number(20), number(20), number(20)};
            if (i % 2 == 0) {
                // The last product almost cancels the others.
                b[2] = near(-(a[0] * b[0] + a[1] * b[1]) / a[2]);
            }
            BigDecimal exact = BigDecimal.ZERO;
            double absolute = 0;
            for (int k = 0; k < 3; k++) {
                exact = exact.add(product(a[k], b[k]));
                absolute += Math.abs(a[k] * b[k]);
            }
            double plain = Products.dot(a[0], a[1], a[2], b[0], b[1], b[2]);
            assertTrue(error(plain, exact) <= Scale.gamma(3) * absolute, "dot " + i);
            double accurate = Products.accurateDot(a[0], a[1], a[2], b[0], b[1], b[2]);
            double size = exact.abs().doubleValue();
            double bound = U * size + Scale.gamma(3) * Scale.gamma(3) * absolute;
            assertTrue(error(accurate, exact) <= bound * (1 + 4 * U), "accurate dot " + i);
            cancelled += size < 1e-9 * absolute ? 1 : 0;
        }
        assertTrue(cancelled > COUNT / 20, cancelled + " cancelled");
    }

    @Test
    void theSquaredDistanceFromASphereIsWithinItsBoundHoweverCloseThePointIs() {
        int close = 0;
        for (int i = 0; i < COUNT; i++) {
            double x = number(20);
            double y = number(20);
            double z = number(20);
            double r = i % 4 == 0 ? number(20) : near(Math.sqrt(x * x + y * y + z * z));
            BigDecimal exact =
                    product(x, x).add(product(y, y)).add(product(z, z)).subtract(product(r, r));
            double squares = x * x + y * y + z * z + r * r;
            double size = exact.abs().doubleValue();
            double bound = U * size + Scale.gamma(4) * Scale.gamma(4) * squares;
            double computed = Products.distanceSquaredMinus(x, y, z, r);
            assertTrue(error(computed, exact) <= bound * (1 + 4 * U), "point " + i);
            if (size > 2 * bound) {
                assertEquals(exact.signum(), (int) Math.signum(computed), "point " + i);
            }
            close += size < 1e-12 * squares && size > 2 * bound ? 1 : 0;
        }
        assertTrue(close > COUNT / 20, close + " close to the sphere");
    }
}

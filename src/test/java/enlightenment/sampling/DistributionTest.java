package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.math.InvalidValueException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DistributionTest {
    private static final MathContext DIGITS = new MathContext(120);

    @Test
    void everyNameGivesTheFamilyOfThatName() {
        assertEquals(List.of("normal", "zeta", "linear"), Distribution.NAMES);
        for (String name : Distribution.NAMES) {
            assertEquals(name, Distribution.of(name).name());
        }
        for (String name : new String[] {"Normal", "", "uniform", null}) {
            InvalidValueException e = assertThrows(InvalidValueException.class, () -> Distribution.of(name));
            assertEquals("proposal", e.key());
            assertTrue(e.getMessage().contains("[normal, zeta, linear]"), e.getMessage());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theDensityHasIntegralOneMeanZeroAndDeviationOne(String name) {
        Distribution d = Distribution.of(name);
        // One half, since the densities are even; the kinks at 0 and √6 fall on panel ends.
        double end = name.equals("linear") ? Math.sqrt(6) : 200;
        double mass = Quadrature.integral(d::density, 0, end, 2000);
        double square = Quadrature.integral(z -> z * z * d.density(z), 0, end, 2000);
        assertEquals(0.5, mass, 2e-15);
        assertEquals(0.5, square, 4e-15);
        for (double z = 0; z < 5; z += 0.125) {
            assertEquals(d.density(z), d.density(-z));
            assertTrue(d.density(z) >= d.density(z + 0.125), "falls from the mean");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theCumulativeIsTheIntegralOfTheDensityIntoTheTails(String name) {
        Distribution d = Distribution.of(name);
        double root = Math.sqrt(6);
        for (double z = -30; z < 4; z += 0.25) {
            // The ends of the linear one's support end a panel.
            double kink = name.equals("linear") && Math.abs(Math.abs(z + 0.125) - root) < 0.125
                    ? Math.copySign(root, z)
                    : z + 0.25;
            double integral =
                    Quadrature.integral(d::density, z, kink, 4) + Quadrature.integral(d::density, kink, z + 0.25, 4);
            double gain = d.cumulative(z + 0.25) - d.cumulative(z);
            double rounding = z < 0 ? 1e-13 * d.cumulative(z + 0.25) : 4e-16;
            assertEquals(integral, gain, rounding, name + " at " + z);
        }
        assertEquals(0.5, d.cumulative(0));
        assertEquals(0, d.cumulative(Double.NEGATIVE_INFINITY));
        assertEquals(1, d.cumulative(Double.POSITIVE_INFINITY));
    }

    @Test
    void theNormalCumulativeAgreesWithItsSeriesInADecimalArithmeticOf120Digits() {
        BigDecimal rootTwoPi = pi().multiply(BigDecimal.valueOf(2)).sqrt(DIGITS);
        double worst = 0;
        for (double z = -0.0625; z > -14; z -= 0.1875) {
            BigDecimal exact = new BigDecimal("0.5").subtract(fromMiddle(-z).divide(rootTwoPi, DIGITS));
            double error = relativeError(NormalDistribution.INSTANCE.cumulative(z), exact);
            worst = Math.max(worst, error);
            BigDecimal upper = BigDecimal.ONE.subtract(exact);
            assertTrue(relativeError(NormalDistribution.INSTANCE.cumulative(-z), upper) < 2.5e-16);
        }
        assertTrue(worst < 2e-15, "relative error " + worst);
    }

    private static double relativeError(double value, BigDecimal exact) {
        return new BigDecimal(value).subtract(exact).abs().divide(exact, DIGITS).doubleValue();
    }

    /** ∫ exp(−t²/2) dt from 0 to z, by Σ (−1)^k z^(2k+1) / (2^k k! (2k+1)). */
    private static BigDecimal fromMiddle(double z) {
        BigDecimal x = new BigDecimal(z);
        BigDecimal square = x.multiply(x);
        BigDecimal power = x;
        BigDecimal sum = x;
        for (int k = 1; power.abs().compareTo(new BigDecimal("1e-110")) > 0 || k < z * z; k++) {
            power = power.multiply(square, DIGITS).divide(BigDecimal.valueOf(-2L * k), DIGITS);
            sum = sum.add(power.divide(BigDecimal.valueOf(2L * k + 1), DIGITS), DIGITS);
        }
        return sum;
    }

    /** Machin: π = 16 arctan(1/5) − 4 arctan(1/239). */
    private static BigDecimal pi() {
        return arctanOfInverse(5)
                .multiply(BigDecimal.valueOf(16))
                .subtract(arctanOfInverse(239).multiply(BigDecimal.valueOf(4)));
    }

    private static BigDecimal arctanOfInverse(long n) {
        BigDecimal power = BigDecimal.ONE.divide(BigDecimal.valueOf(n), DIGITS);
        BigDecimal sum = power;
        for (int k = 1; k < 200; k++) {
            power = power.divide(BigDecimal.valueOf(-n * n), DIGITS);
            sum = sum.add(power.divide(BigDecimal.valueOf(2L * k + 1), DIGITS), DIGITS);
        }
        return sum;
    }

    @Test
    void theZetaDensityIsTheSumOfItsPowers() {
        double half = 0;
        double cubes = 0;
        for (int n = 2; n <= 50; n++) {
            half += 1 / StrictMath.log(n);
            cubes += 1 / StrictMath.pow(StrictMath.log(n), 3);
        }
        double scale = Math.sqrt(2 * cubes / half);
        for (double z = 0; z < 80; z += 0.0371) {
            double sum = 0;
            double tail = 0;
            for (int n = 2; n <= 50; n++) {
                double power = StrictMath.pow(n, -scale * z);
                sum += power;
                tail += power / StrictMath.log(n);
            }
            assertEquals(1, ZetaDistribution.INSTANCE.density(z) * 2 * half / (scale * sum), 1e-13, "at " + z);
            assertEquals(1, ZetaDistribution.INSTANCE.cumulative(-z) * 2 * half / tail, 1e-13, "at " + z);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theQuantileOfTheCumulativeIsTheSameValue(String name) {
        Distribution d = Distribution.of(name);
        double end = name.equals("linear") ? Math.sqrt(6) : name.equals("normal") ? 37 : 300;
        double steps = 4000;
        for (int i = 1; i < steps; i++) {
            double z = -end * i / steps;
            double p = d.cumulative(z);
            // An ulp of z, and what four roundings of p amount to.
            assertEquals(z, d.quantile(p), 4 * Math.ulp(z) + 4 * Math.ulp(p) / d.density(z), name + " at " + z);
            double q = d.cumulative(-z);
            if (q < 1 - 1e-9) {
                assertEquals(-z, d.quantile(q), 4 * Math.ulp(z) + 4 * Math.ulp(1.0) / d.density(z), name);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"normal", "zeta", "linear"})
    void theQuantileGrowsAndItsEndsAreThoseOfTheSupport(String name) {
        Distribution d = Distribution.of(name);
        double end = name.equals("linear") ? Math.sqrt(6) : Double.POSITIVE_INFINITY;
        assertEquals(-end, d.quantile(0));
        assertEquals(end, d.quantile(1));
        assertEquals(0, d.quantile(0.5));
        double before = d.quantile(Double.MIN_VALUE);
        for (int k = -1070; k <= -2; k++) {
            for (double p = Math.scalb(1.0, k), step = p / 16;
                    p < Math.scalb(1.0, k + 1);
                    p += Math.max(step, 0x1p-1074)) {
                double z = d.quantile(p);
                assertTrue(z >= before - 4 * Math.ulp(before), name + " at " + p);
                if (p > 1e-6) {
                    assertEquals(-z, d.quantile(1 - p), 1e-9);
                }

                before = z;
            }
        }
        for (double p : new double[] {-0x1p-60, 1 + 0x1p-52, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> d.quantile(p));
        }
    }
}

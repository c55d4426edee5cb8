package enlightenment.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RunningStatisticsTest {
    private static final MathContext DIGITS = new MathContext(60);
    private static final int MILLION = 1_000_000;

    /** Roughly normal values: the sum of twelve uniform ones, so that no function of the machine takes part. */
    private static double[] values(double mean, double deviation, int n) {
        SplittableRandom random = new SplittableRandom(37);
        double[] values = new double[n];
        for (int i = 0; i < n; i++) {
            double sum = -6;
            for (int k = 0; k < 12; k++) {
                sum += random.nextDouble();
            }
            values[i] = mean + deviation * sum;
        }
        return values;
    }

    private static RunningStatistics of(double[] values, int from, int to) {
        RunningStatistics s = new RunningStatistics();
        for (int i = from; i < to; i++) {
            s.add(values[i]);
        }
        return s;
    }

    /** Mean and standard deviation of exactly these doubles, summed in integers. */
    private static BigDecimal[] exact(double[] values) {
        // Values this close to each other have exact differences, which are multiples of a small unit.
        double unit = Math.ulp(values[0]) / 4;
        BigInteger sum = BigInteger.ZERO;
        BigInteger squares = BigInteger.ZERO;
        for (double v : values) {
            double steps = (v - values[0]) / unit;
            assertEquals(Math.rint(steps), steps, "the difference is exact");
            BigInteger k = BigInteger.valueOf((long) steps);
            sum = sum.add(k);
            squares = squares.add(k.multiply(k));
        }
        BigDecimal n = BigDecimal.valueOf(values.length);
        BigDecimal mean = new BigDecimal(sum).divide(n, DIGITS);
        BigDecimal variance = new BigDecimal(squares)
                .subtract(new BigDecimal(sum).multiply(mean))
                .divide(n.subtract(BigDecimal.ONE), DIGITS);
        BigDecimal u = new BigDecimal(unit);
        return new BigDecimal[] {
            new BigDecimal(values[0]).add(mean.multiply(u)),
            variance.sqrt(DIGITS).multiply(u)
        };
    }

    private static double relativeError(double v, BigDecimal exact) {
        return new BigDecimal(v).subtract(exact).divide(exact, DIGITS).abs().doubleValue();
    }

    @ParameterizedTest
    @CsvSource({"1, 1e-3", "1e3, 1e-3", "1e6, 1e-3", "1e9, 1e-3", "1, 1e-6", "1e3, 1e-6", "1e6, 1e-6", "1e9, 1e-6"})
    void theDeviationOfAMillionIsRightOneByOneAndMerged(double mean, double deviation) {
        double[] values = values(mean, deviation, MILLION);
        BigDecimal[] exact = exact(values);
        RunningStatistics oneByOne = of(values, 0, MILLION);
        RunningStatistics halves = of(values, 0, MILLION / 2);
        halves.merge(of(values, MILLION / 2, MILLION));
        RunningStatistics uneven = of(values, 0, 7);
        uneven.merge(of(values, 7, MILLION));
        for (RunningStatistics s : new RunningStatistics[] {oneByOne, halves, uneven}) {
            assertEquals(MILLION, s.count());
            assertTrue(relativeError(s.mean(), exact[0]) <= 4e-16, s.mean() + " is not " + exact[0]);
            assertTrue(s.variance() >= 0);
            if (deviation > 100 * Math.ulp(mean)) {
                double error = relativeError(s.standardDeviation(), exact[1]);
                assertTrue(error <= 1e-9, "the deviation is off by " + error);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 1e9, -1e300, 4.9e-324})
    void valuesThatAreAllTheSameDoNotDeviate(double value) {
        RunningStatistics s = new RunningStatistics();
        RunningStatistics other = new RunningStatistics();
        for (int i = 0; i < 1000; i++) {
            s.add(value);
            other.add(value);
        }
        s.merge(other);
        assertEquals(value, s.mean());
        assertEquals(0, s.variance());
        assertEquals(0, s.standardError());
    }

    @Test
    void neighbouringDoublesNeverGiveANegativeVariance() {
        SplittableRandom random = new SplittableRandom(5);
        for (int run = 0; run < 200; run++) {
            double base = 1e9 * random.nextDouble();
            RunningStatistics all = new RunningStatistics();
            for (int part = 0; part < 10; part++) {
                RunningStatistics s = new RunningStatistics();
                for (int i = 0; i < 10; i++) {
                    s.add(base + Math.ulp(base) * random.nextInt(3));
                    assertTrue(s.variance() >= 0);
                }
                all.merge(s);
                assertTrue(all.variance() >= 0 && all.variance() <= 4 * Math.ulp(base) * Math.ulp(base));
            }
        }
    }

    @Test
    void fewValuesHaveTheVarianceOfTheTextbook() {
        RunningStatistics s = new RunningStatistics();
        assertEquals(0, s.mean());
        assertEquals(0, s.variance());
        s.add(2);
        assertEquals(2, s.mean());
        assertEquals(0, s.standardDeviation());
        s.add(4);
        s.add(9);
        assertEquals(5, s.mean());
        assertEquals(13, s.variance());
        assertEquals(Math.sqrt(13.0 / 3), s.standardError(), 1e-15);
    }

    @Test
    void mergingWithNothingChangesNothing() {
        RunningStatistics s = of(new double[] {1, 2, 4}, 0, 3);
        double variance = s.variance();
        s.merge(new RunningStatistics());
        assertEquals(variance, s.variance());
        RunningStatistics empty = new RunningStatistics();
        empty.merge(s);
        assertEquals(3, empty.count());
        assertEquals(s.mean(), empty.mean());
        assertEquals(variance, empty.variance());
    }

    @Test
    void mergingWithItselfDoublesTheCountAndKeepsTheMean() {
        RunningStatistics s = of(new double[] {1, 2, 6}, 0, 3);
        s.merge(s);
        assertEquals(6, s.count());
        assertEquals(3, s.mean());
        // Squared differences 4 + 1 + 9, twice, over 6 - 1.
        assertEquals(28 / 5.0, s.variance(), 1e-15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void whatIsNoNumberIsRefused(double value) {
        RunningStatistics s = of(new double[] {1, 2}, 0, 2);
        assertThrows(IllegalArgumentException.class, () -> s.add(value));
        assertEquals(2, s.count());
        assertEquals(1.5, s.mean());
    }
}

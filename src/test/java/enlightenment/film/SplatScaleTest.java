package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SplatScaleTest {
    @ParameterizedTest
    @CsvSource({
        "1, 1, 1",
        "0.3, 1000000, 320000",
        "1.999, 3, 2",
        "1e-300, 7, 1000000000",
        "4.9e-324, 1, 9223372036854775807",
        "1.7976931348623157e308, 9223372036854775807, 1"
    })
    void theMeanPixelGetsTwoToTheThirtySecondUnitsOrUpToTwiceAsMany(double contribution, long paths, long pixels) {
        SplatScale scale = SplatScale.of(contribution, paths, pixels);
        BigDecimal mean = new BigDecimal(contribution).multiply(BigDecimal.valueOf(paths));
        BigDecimal two = BigDecimal.valueOf(2);
        int s = scale.exponent();
        BigDecimal units = s >= 0 ? mean.multiply(two.pow(s)) : mean;
        BigDecimal one = BigDecimal.valueOf(pixels).multiply(s >= 0 ? BigDecimal.ONE : two.pow(-s));
        assertTrue(units.compareTo(one.multiply(two.pow(32))) >= 0);
        // Paths and pixels are rounded to doubles: so it may be just as much.
        assertTrue(units.compareTo(one.multiply(two.pow(33))) <= 0);
    }

    @Test
    void whereNothingShinesAnyUnitWillDo() {
        assertEquals(new SplatScale(0), SplatScale.of(0, 5, 7));
    }

    @ParameterizedTest
    @CsvSource({"-1, 1, 1", "NaN, 1, 1", "Infinity, 1, 1", "1, 0, 1", "1, 1, 0"})
    void whatIsNoExpectationIsRefused(double contribution, long paths, long pixels) {
        assertThrows(IllegalArgumentException.class, () -> SplatScale.of(contribution, paths, pixels));
    }

    @ParameterizedTest
    @CsvSource({"-1054", "-1024", "-1023", "-1", "0", "38", "1022", "1023", "1024", "1169"})
    void unitsAreWorthTheirPowerOfTwoRoundedOnce(int exponent) {
        for (double units : new double[] {0, 1, 3, 1e18, 0x1.123456789abcdp60, 1.7e308}) {
            assertEquals(Math.scalb(units, -exponent), new SplatScale(exponent).value(units));
        }
    }

    @ParameterizedTest
    @CsvSource({"-1100", "1200"})
    void anExponentThatNoRenderHasIsRefused(int exponent) {
        assertThrows(IllegalArgumentException.class, () -> new SplatScale(exponent));
    }
}

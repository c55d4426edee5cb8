package enlightenment.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import java.math.BigDecimal;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TidyTest {
    @ParameterizedTest
    @ValueSource(
            doubles = {
                Double.NaN,
                Double.NEGATIVE_INFINITY,
                -Double.MAX_VALUE,
                -37,
                -Double.MIN_VALUE,
                -0.0,
                0,
                Double.MIN_VALUE,
                0x1p-1023,
                1e-9,
                0.99
            })
    void whatIsTooFewOrNoNumberBecomesOne(double samples) {
        // It once never ended; the limit of the whole suite would tell.
        assertEquals(1, Tidy.of(samples));
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {RenderSettings.Budget.MAX_SAMPLES, 1.678e7, 1e9, Double.MAX_VALUE, Double.POSITIVE_INFINITY})
    void whatIsTooManyBecomesTheMost(double samples) {
        assertEquals(RenderSettings.Budget.MAX_SAMPLES, Tidy.of(samples));
    }

    @ParameterizedTest
    @CsvSource({
        "1, 1",
        "2.444, 2.44",
        "2.446, 2.45",
        "12.341, 12.3",
        "12.36, 12.4",
        "99.96, 100",
        "1234, 1230",
        "1235001, 1240000",
        "999.6, 1000"
    })
    void threeDigitsAreKept(double samples, double tidy) {
        assertEquals(tidy, Tidy.of(samples));
    }

    @Test
    void itIsNearAndShortAndStaysWhatItIs() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 20_000; i++) {
            double samples = Math.scalb(1 + random.nextDouble(), random.nextInt(24));
            double tidy = Tidy.of(samples);
            assertEquals(1, tidy / samples, 0.005 + 1e-12);
            int digits = BigDecimal.valueOf(tidy).stripTrailingZeros().precision();
            assertTrue(digits <= 3 || tidy == RenderSettings.Budget.MAX_SAMPLES, samples + " became " + tidy);
            assertEquals(tidy, Tidy.of(tidy));
        }
    }
}

package enlightenment.measure.analysis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DigitsTest {
    @ParameterizedTest
    @CsvSource({"0.2, 1", "1, 1", "1.01, 1.1", "2.9, 2.9", "23.1, 24", "24, 24", "1234, 1300", "1e9, 16777216"})
    void samplesAreRoundedUpToTwoDigitsWithinTheLimits(double samples, double rounded) {
        assertEquals(rounded, Digits.upTwo(samples));
    }

    @ParameterizedTest
    @CsvSource({"2, 0.012345, 0.012", "3, 2, 2.00", "2, 123.4, 120", "2, 0.0999, 0.10", "3, 0, 0", "2, 9.97, 10"})
    void numbersGetTheDigitsThatWereAskedForAndNoExponent(int digits, double value, String text) {
        assertEquals(text, Digits.of(value, digits));
    }

    @Test
    void samplesAreWrittenAsTheyAreTyped() {
        assertEquals("24", Digits.samples(24));
        assertEquals("1300", Digits.samples(1300));
        assertEquals("2.9", Digits.samples(2.9));
    }
}

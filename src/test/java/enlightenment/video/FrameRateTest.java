package enlightenment.video;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FrameRateTest {
    @ParameterizedTest
    @CsvSource({
        "25, 25/1",
        "23.976, 2997/125",
        "29.97, 2997/100",
        "0.1, 1/10",
        "12.5, 25/2",
        "65535, 65535/1",
        "59.94005994005994, 60000/1001",
        "0.333333333333333333, 1/3"
    })
    void aRateIsTheFractionThatWasMeant(double perSecond, String fraction) {
        assertEquals(fraction, FrameRate.of(perSecond).toString());
    }

    @ParameterizedTest
    @ValueSource(doubles = {Math.PI, 1e-3 * Math.E, 24.00001234, 1 / 65535.0, 65534.99999})
    void otherRatesAreAsCloseAsThereIsRoomFor(double perSecond) {
        FrameRate rate = FrameRate.of(perSecond);
        // A convergent p/q is within 1/q² of the number, or the next one would have had room.
        double value = (double) rate.frames() / rate.seconds();
        assertTrue(Math.abs(value - perSecond) * rate.seconds() <= Math.max(perSecond, 1) / 65535 * 2, rate.toString());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-5, 65536, Double.POSITIVE_INFINITY, Double.NaN, -25})
    void ratesThatNoFileHasRoomForAreRefused(double perSecond) {
        assertThrows(IllegalArgumentException.class, () -> FrameRate.of(perSecond));
    }

    @ParameterizedTest
    @ValueSource(doubles = {25, 24, 29.97, 12.5, 48, 0.5})
    void hundredthsOfASecondAddUpToTheFilmsLength(double perSecond) {
        FrameRate rate = FrameRate.of(perSecond);
        int frames = 1000;
        int sum = IntStream.range(0, frames).map(rate::hundredths).sum();
        assertTrue(Math.abs(sum - 100 * frames / perSecond) <= 1, sum + " hundredths");
    }

    @Test
    void noFrameIsShownForLessThanPlayersTakeSeriously() {
        assertEquals(2, FrameRate.of(120).hundredths(7));
    }
}

package enlightenment.color;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Colours as words of hexadecimal digits. */
class DisplayRgbTest {
    @Test
    void sixDigitsAreThreeBytes() {
        assertEquals(Optional.of(DisplayRgb.ofBytes(18, 171, 255)), DisplayRgb.ofHexadecimal("#12abFF"));
        assertEquals(Optional.of(DisplayRgb.BLACK), DisplayRgb.ofHexadecimal("#000000"));
        assertEquals(Optional.of(DisplayRgb.WHITE), DisplayRgb.ofHexadecimal("#ffffff"));
    }

    @Test
    void eachOfThreeDigitsStandsForTwo() {
        assertEquals(DisplayRgb.ofHexadecimal("#11aaFF"), DisplayRgb.ofHexadecimal("#1aF"));
    }

    @Test
    void nothingElseIsAColour() {
        for (String text :
                List.of("", "#", "#12", "#1234", "#12345", "#1234567", "1234567", "#00000g", "#-12345", "##12")) {
            assertEquals(Optional.empty(), DisplayRgb.ofHexadecimal(text), text);
        }
        assertEquals(Optional.empty(), DisplayRgb.ofHexadecimal("#12345\u0666"), "a digit of another script");
    }
}

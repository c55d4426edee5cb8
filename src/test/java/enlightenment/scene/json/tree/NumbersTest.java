package enlightenment.scene.json.tree;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class NumbersTest {
    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, -0.0",
        "0.1, 0.1",
        "100, 100",
        "-2.5, -2.5",
        "1e15, 1000000000000000",
        "1e20, 100000000000000000000",
        "1e21, 1e21",
        "1.5e22, 1.5e22",
        "1e-7, 0.0000001",
        "1e-8, 1e-8",
        "-1.25e-9, -1.25e-9",
        "4.9e-324, 5e-324",
        "1.7976931348623157e308, 1.7976931348623157e308",
        // Two that Double.toString of Java 17 writes with a digit too many.
        "2e23, 2e23",
        "2.2250738585072014e-308, 2.2250738585072014e-308"
    })
    void doublesAreWrittenShort(double v, String text) {
        assertEquals(text, Numbers.text(v));
    }

    @Test
    void everyDoubleIsReadBackExactly() {
        Random random = new Random(1);
        for (int i = 0; i < 20_000; ) {
            double v = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(v)) {
                i++;
                String text = Numbers.text(v);
                assertEquals(v, Double.parseDouble(text), text);
                assertNull(Numbers.objection(text), text);
                assertTrue(text.length() <= 27, text);
            }
        }
    }

    @Test
    void exactNumbersAreWrittenWithAllTheirDigits() {
        for (String s : new String[] {"0.1", "-12.5", "1e30", "123456789012345678901234567890.5", "4.25e-300"}) {
            BigDecimal v = new BigDecimal(s);
            assertEquals(0, v.compareTo(new BigDecimal(Numbers.text(v))), s);
        }
        assertEquals("100", Numbers.text(new BigDecimal("1E+2")));
        assertEquals("0.5", Numbers.text(new BigDecimal("0.500")));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-0.0",
                "0.0e-300",
                "1e308",
                "4.9e-324",
                "1E+2",
                "0.000001e310",
                "100000000000000000000e-340"
            })
    void numbersInTheRangeOfDoublesAreTaken(String text) {
        assertNull(Numbers.objection(text));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "NaN",
                "Infinity",
                "-Infinity",
                "1e309",
                "-1e309",
                "1e-400",
                "2e-324",
                "1e401",
                "1e-401",
                "1e1000000000",
                "1e-99999999999999999999",
                "0.1e1000000000"
            })
    void numbersBeyondTheRangeOfDoublesAreRefused(String text) {
        String objection = Numbers.objection(text);
        assertNotNull(objection);
        assertTrue(objection.contains(text), objection);
    }

    @Test
    void aNumberMayHaveTwoThousandDigits() {
        assertNull(Numbers.objection("0." + "1".repeat(1999)));
        assertNotNull(Numbers.objection("0." + "1".repeat(2000)));
        assertNotNull(Numbers.objection("0." + "0".repeat(2000)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-0",
                "-0.0",
                "0e0",
                "0e-900",
                "-0e900",
                "0E+400",
                "0.000e401",
                "0e-99999999999999999999",
                "-0.0e99999999999999999999",
                "0e0000000000000000000000000001"
            })
    void zeroIsZeroHoweverItIsSpelled(String text) {
        assertNull(Numbers.objection(text));
        assertEquals(0, Numbers.exact(text).signum());
        assertTrue(Double.parseDouble(text) == 0);
    }

    @ParameterizedTest
    @CsvSource({
        "1e+0000000000000000000000000000000005, 1e5",
        "1e-0000000000000000000000000000000005, 1e-5",
        "-2.50E-000320, -2.5e-320",
        "00000.1e00001, 1",
        "4.9e-324, 4.9e-324",
        "2.5e-324, 2.5e-324",
        "1.7976931348623158e308, 1.7976931348623157e308",
        "0.00000000000000000001e328, 1e308"
    })
    void oddSpellingsAreTheNumbersThatTheyMean(String text, double v) {
        assertNull(Numbers.objection(text));
        assertEquals(v, Double.parseDouble(text));
        assertEquals(v, Numbers.exact(text).doubleValue());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1.797693134862315808e308", "1e400", "2.4e-324", "1e-400", "0.0001e401"})
    void justBeyondTheRangeIsBeyondIt(String text) {
        assertNotNull(Numbers.objection(text));
    }
}

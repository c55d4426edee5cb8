package enlightenment.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ExactPointEqualityTest {
    @Test
    void equalCoordinatesAreEqualHoweverTheyWereWritten() {
        for (List<String> same : List.of(
                List.of("100000", "1e5", "1E+5", "100000.00", "0.1e6"),
                List.of("100000000", "1e8", "100000000.0"),
                List.of("1000000000", "1e9", "1000000000.0"),
                List.of("0", "-0", "0.000", "0e9"),
                List.of("-0.5", "-0.50", "-5e-1"))) {
            for (String s : same) {
                ExactPoint p = ExactPoint.of(s, s, s);
                assertEquals(ExactPoint.of(same.get(0), same.get(0), same.get(0)), p);
                assertEquals(
                        ExactPoint.of(same.get(0), same.get(0), same.get(0)).hashCode(), p.hashCode());
            }
        }
        assertEquals(ExactPoint.of("1e15", "1e5", "0.5"), ExactPoint.of(1e15, 1e5, 0.5));
        assertNotEquals(ExactPoint.of("1", "0", "0"), ExactPoint.of("1.0000000000000000000001", "0", "0"));
    }
}

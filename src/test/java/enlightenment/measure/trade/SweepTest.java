package enlightenment.measure.trade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SweepTest {
    @Test
    void antialiasGoesUpByOneAndShadowSamplesDouble() {
        assertEquals(List.of(1, 2, 3, 4), Sweep.parse("antialias=1..4").values());
        assertEquals(List.of(1, 2, 4, 8, 16), Sweep.parse("shadowSamples=1..16").values());
        assertEquals(List.of(5, 10, 12), Sweep.parse("shadowSamples=5..12").values());
        assertEquals(
                List.of(1, 2, 4, 8, 16, 32, 40), Sweep.parse("threads=1..40").values());
    }

    @Test
    void nIsTheNumberOfProcessors() {
        List<Integer> values = Sweep.parse("threads=1..N").values();
        assertEquals(1, values.get(0));
        assertEquals(Runtime.getRuntime().availableProcessors(), values.get(values.size() - 1));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "antialias",
                "antialias=",
                "antialias=3",
                "antialias=4..1",
                "antialias=0..3",
                "seeds=1..3",
                "antialias=1..99999999",
                "antialias=-1..3",
                "antialias=1...3"
            })
    void whatIsNoSweepIsRefusedWithItsText(String text) {
        String message = assertThrows(IllegalArgumentException.class, () -> Sweep.parse(text))
                .getMessage();
        assertTrue(message.startsWith("must ") && message.contains("\"" + text + "\""), message);
    }
}

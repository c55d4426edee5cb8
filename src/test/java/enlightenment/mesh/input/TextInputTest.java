package enlightenment.mesh.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.mesh.SmallMeshFiles;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class TextInputTest {
    private static TextInput input(String text) throws IOException {
        MeshSource source = MeshSource.of(SmallMeshFiles.bytes(text), "a");
        return new TextInput(source, source.open(0), 1);
    }

    private static List<String> words() {
        List<String> words = new ArrayList<>(List.of(
                "0",
                "-0",
                "+1",
                ".5",
                "5.",
                "1e22",
                "1e23",
                "9007199254740993",
                "9007199254740992e1",
                "4.9e-324",
                "2.5e-324",
                "1.7976931348623157e308",
                "1e-400",
                "0e999999999999",
                "123456789012345678901234567890",
                "0.1e-22",
                "1E+05"));
        Random random = new Random(7);
        for (int i = 0; i < 20_000; i++) {
            words.add(
                    switch (i % 4) {
                        case 0 -> Double.toString(Double.longBitsToDouble(random.nextLong() & ~(1L << 62)));
                        case 1 -> Float.toString(Float.intBitsToFloat(random.nextInt() & ~(1 << 30)));
                        case 2 -> random.nextInt(100_000) + "." + random.nextInt(1_000_000);
                        default -> "-." + random.nextLong(Long.MAX_VALUE) + "e" + (random.nextInt(60) - 30);
                    });
        }
        words.removeIf(w -> w.contains("N") || w.contains("I"));
        return words;
    }

    @Test
    void numbersAreRoundedCorrectlyToDoubles() throws IOException {
        List<String> words = words();
        TextInput in = input(String.join("\n", words));
        for (String word : words) {
            in.space();
            assertEquals(Double.parseDouble(word), in.number(), word);
        }
    }

    @Test
    void numbersAreRoundedCorrectlyToFloats() throws IOException {
        List<String> words = words();
        words.add("1.00000005960464477540");
        words.add("1.00000005960464477539");
        words.add("1.17549429e-38");
        words.add("7.0064923216240853546186479164495807e-46");
        words.removeIf(w -> Float.isInfinite(Float.parseFloat(w)));
        // Halves between neighbouring floats, a little above and below.
        for (int i = 1; i < 200; i++) {
            double half = 1 + (2 * i + 1) * 0x1p-24;
            words.add(new BigDecimal(half).toPlainString());
            words.add(new BigDecimal(half).toPlainString() + "0000000000000000000001");
        }
        TextInput in = input(String.join(" ", words));
        for (String word : words) {
            in.space();
            assertEquals(Float.parseFloat(word), in.floatNumber(), word);
        }
    }
}

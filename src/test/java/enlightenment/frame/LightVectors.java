package enlightenment.frame;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Reads the solid angles and densities of {@code light-vectors.jsonl}, which are known to 20 digits. */
public final class LightVectors {
    private LightVectors() {}

    /** The lines of one kind, "sphereLight" or "rectLight": numbers as they are written, by their names. */
    public static List<Map<String, String>> of(String kind) {
        List<Map<String, String>> lines = new ArrayList<>();
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(
                LightVectors.class.getResourceAsStream("light-vectors.jsonl"), StandardCharsets.UTF_8))) {
            for (String line = reader.readLine(); line != null; line = reader.readLine()) {
                Map<String, String> values = parse(line);
                if (values.get("kind").equals(kind)) {
                    lines.add(values);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return lines;
    }

    /** One flat object of numbers and texts without commas. */
    private static Map<String, String> parse(String line) {
        Map<String, String> values = new HashMap<>();
        for (String entry : line.replaceAll("[{}\" ]", "").split(",")) {
            String[] pair = entry.split(":");
            values.put(pair[0], pair[1]);
        }
        return values;
    }
}

package enlightenment.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The scene that docs/notes/benchmarks.md compares with POV-Ray is the same in both languages. */
class PlainSceneTest {
    private static final String NUMBERS = "([-\\d., ]+)";
    private static String pov;
    private static String json;

    @BeforeAll
    static void read() throws IOException {
        pov = Files.readString(Path.of("src/bench/povray/fire-and-ice.pov"));
        json = Files.readString(Path.of("src/bench/scenes/fire-and-ice-plain.json"));
    }

    private static List<Double> numbers(String text) {
        List<Double> numbers = new ArrayList<>();
        Matcher m = Pattern.compile("-?\\d+(?:\\.\\d+)?").matcher(text);
        while (m.find()) {
            numbers.add(Double.valueOf(m.group()));
        }
        return numbers;
    }

    private static String color(String material) {
        Matcher m = Pattern.compile("\"" + material + "\": \\{ \"type\": \"matte\", \"color\": \"#(\\w{6})\"")
                .matcher(json);
        assertTrue(m.find(), material);
        int rgb = Integer.parseInt(m.group(1), 16);
        return List.of((double) (rgb >> 16), (double) (rgb >> 8 & 0xff), (double) (rgb & 0xff))
                .toString();
    }

    /** Corners in any order, with the colour. */
    @Test
    void wallsHaveTheSameCornersAndColours() {
        TreeSet<String> theirs = new TreeSet<>();
        Matcher m = Pattern.compile("object \\{ Wall\\((.*)\\) Plain\\(" + NUMBERS + "\\) \\}")
                .matcher(pov);
        while (m.find()) {
            theirs.add(corners(m.group(1)) + " " + numbers(m.group(2)));
        }
        TreeSet<String> ours = new TreeSet<>();
        m = Pattern.compile("\"corners\": \\[(.*)\\], \"material\": \"([^\"]*)\"")
                .matcher(json);
        while (m.find()) {
            ours.add(corners(m.group(1)) + " " + color(m.group(2)));
        }
        assertEquals(5, ours.size());
        assertEquals(ours, theirs);
    }

    private static TreeSet<String> corners(String text) {
        List<Double> n = numbers(text);
        TreeSet<String> corners = new TreeSet<>();
        for (int i = 0; i < n.size(); i += 3) {
            corners.add(n.subList(i, i + 3).toString());
        }
        return corners;
    }

    @Test
    void spheresAndLampAreTheSame() {
        TreeSet<String> theirs = new TreeSet<>();
        Matcher m = Pattern.compile("sphere \\{ <" + NUMBERS + ">, ([\\d.]+) (?:Plain\\(" + NUMBERS + "\\))?")
                .matcher(pov);
        while (m.find()) {
            String color = m.group(3) == null ? "" : numbers(m.group(3)).toString();
            theirs.add(numbers(m.group(1)) + " " + Double.valueOf(m.group(2)) + " " + color);
        }
        TreeSet<String> ours = new TreeSet<>();
        m = Pattern.compile("\"center\": \\[" + NUMBERS
                        + "\\], \"radius\": ([\\d.]+), \"(?:material|color)\": \"([^\"]*)\"")
                .matcher(json);
        while (m.find()) {
            String color = m.group(3).matches("mirror|#.*") ? "" : color(m.group(3));
            ours.add(numbers(m.group(1)) + " " + Double.valueOf(m.group(2)) + " " + color);
        }
        assertEquals(4, ours.size());
        assertEquals(ours, theirs);
    }

    /** 7 × 7 light samples, half of the light ambient, nothing of the rest in a shadow. */
    @Test
    void lightAndShadingAreTheSame() {
        assertTrue(pov.contains("7, 7 circular") && json.contains("\"shadowSamples\": 49"));
        assertTrue(pov.contains("finish { ambient 0.5 diffuse 0.5 }"));
        assertTrue(json.contains("\"ambient\": 0.5, \"shadow\": 0 "));
    }
}

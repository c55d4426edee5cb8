package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayRgb;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class ColorNamesTest {
    @TempDir
    Path folder;

    private DisplayRgb background(String color) {
        Scene scene = Documents.read(Documents.edited("\"#102030\"", "\"" + color + "\""), Documents.withImage(folder));
        return ((Shading.Classic) scene.shading()).background();
    }

    @Test
    void thereAre148Names() {
        assertEquals(148, ColorNames.ALL.size());
        assertTrue(ColorNames.ALL.values().stream().allMatch(c -> c >= 0 && c <= 0xffffff));
        assertTrue(ColorNames.ALL.keySet().stream().allMatch(n -> n.matches("[a-z]+")));
    }

    /** The sixteen of HTML 4, whose components are 0, 80, c0 and ff, in the order of that standard. */
    @Test
    void theOldestSixteenAreThoseOfHtml() {
        Map<String, Integer> html = Map.ofEntries(
                Map.entry("black", 0),
                Map.entry("silver", 0xc0c0c0),
                Map.entry("gray", 0x808080),
                Map.entry("white", 0xffffff),
                Map.entry("maroon", 0x800000),
                Map.entry("red", 0xff0000),
                Map.entry("purple", 0x800080),
                Map.entry("fuchsia", 0xff00ff),
                Map.entry("green", 0x008000),
                Map.entry("lime", 0x00ff00),
                Map.entry("olive", 0x808000),
                Map.entry("yellow", 0xffff00),
                Map.entry("navy", 0x000080),
                Map.entry("blue", 0x0000ff),
                Map.entry("teal", 0x008080),
                Map.entry("aqua", 0x00ffff));
        html.forEach((name, rgb) -> assertEquals(rgb, ColorNames.ALL.get(name), name));
    }

    /** Nine colours have two names. */
    @Test
    void twoNamesForOneColourAreThoseOfTheStandard() {
        assertEquals(ColorNames.ALL.get("aqua"), ColorNames.ALL.get("cyan"));
        assertEquals(ColorNames.ALL.get("fuchsia"), ColorNames.ALL.get("magenta"));
        long greys = ColorNames.ALL.keySet().stream()
                .filter(n -> n.contains("grey"))
                .peek(n -> assertEquals(ColorNames.ALL.get(n.replace("grey", "gray")), ColorNames.ALL.get(n), n))
                .count();
        assertEquals(7, greys);
        // 148 names less 9 second ones.
        assertEquals(139, new TreeSet<>(ColorNames.ALL.values()).size());
    }

    @Test
    void aNameIsItsSixDigits() {
        ColorNames.ALL.forEach(
                (name, rgb) -> assertEquals(background(String.format("#%06x", rgb)), background(name), name));
        assertNotEquals(background("rebeccapurple"), background("purple"));
        assertEquals(DisplayRgb.ofBytes(0x66, 0x33, 0x99), background("rebeccapurple"));
    }

    @Test
    void threeDigitsAreSixOfThemTwice() {
        for (int rgb = 0; rgb < 0x1000; rgb += 31) {
            String three = String.format("%03x", rgb);
            String six = three.replaceAll("(.)", "$1$1");
            assertEquals(background("#" + six), background("#" + three), three);
        }
        assertEquals(background("#ABCDEF"), background("#abcdef"));
        assertEquals(background("#AABBCC"), background("#AbC"));
    }

    @Test
    void whereverAColourStandsAWordMayStand() {
        Scene scene = Documents.read(
                Documents.EVERYTHING
                        .replace("[0.1, 0.2, 0.3]", "\"#fa0\"")
                        .replace("[\"#ffffff\", [0, 0.5, 1]]", "[\"white\", \"#08f\"]")
                        .replace("\"#0000ff\"", "\"blue\"")
                        .replace("\"#ffffee\"", "\"ivory\""),
                Documents.withImage(folder));
        assertEquals(DisplayRgb.ofBytes(255, 255, 240), scene.lights().get(1).color());
        assertTrue(SceneWriter.toJson(scene, folder).contains("#ffaa00"), "the writer writes digits");
    }

    @Test
    void theSchemaHasTheSameNames() {
        JsonNode forms = new JsonMapper()
                .readTree(SceneSchema.text())
                .get("$defs")
                .get("plainColor")
                .get("oneOf");
        List<String> names =
                forms.get(1).get("enum").valueStream().map(JsonNode::asString).toList();
        assertEquals(List.copyOf(ColorNames.ALL.keySet()), names);
    }
}

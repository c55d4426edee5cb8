package enlightenment.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** The guide can be read: pages are short, begin with something to see or to do, and their scenes are scenes. */
class GuidePagesTest {
    private static final JsonMapper JSON =
            JsonMapper.builder().enable(JsonReadFeature.ALLOW_JAVA_COMMENTS).build();

    /** Long tables that tests of their own hold against the program. */
    private static final Set<Path> REFERENCE =
            Set.of(Path.of("docs/guide/cli.md"), Path.of("docs/guide/scene-format.md"));

    /** Into which parts of scenes are put. */
    private static final String FRAME =
            """
            {
              "image": { "width": 8, "height": 8 },
              "camera": { "type": "perspective", "eye": [0, 1, -9], "lookAt": [0, 1, 0], "fieldOfView": 30 },
              "shading": { "model": "physical" },
              "objects": []
            }
            """;

    private static List<Path> pages() throws IOException {
        return GuidePages.all().stream().filter(p -> !REFERENCE.contains(p)).toList();
    }

    @Test
    void pagesHaveAtMostTwoHundredLinesOfReadableLength() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Path page : pages()) {
            List<String> lines = Files.readAllLines(page);
            if (lines.size() > 200) {
                wrong.add(page + " has " + lines.size() + " lines");
            }
            for (int i = 0; i < lines.size(); i++) {
                // A row of a table cannot be broken, nor can a link.
                int most = lines.get(i).startsWith("|") ? 399 : 150;
                if (lines.get(i).length() > most) {
                    wrong.add(page + ":" + (i + 1) + " has " + lines.get(i).length() + " characters");
                }
            }
        }
        assertEquals(List.of(), wrong);
    }

    @Test
    void everyPageOfTheGuideBeginsWithACommandAPictureOrATable() throws IOException {
        List<String> wrong = new ArrayList<>();
        for (Path page : pages()) {
            boolean begins =
                    Files.readAllLines(page).stream().skip(1).limit(5).anyMatch(l -> l.matches("(```|\\[?!\\[|\\|).*"));
            if (!begins) {
                wrong.add(page.toString());
            }
        }
        assertEquals(List.of(), wrong);
    }

    @Test
    void everyPageIsInTheIndexOfTheGuide() throws IOException {
        Path index = Path.of("docs/guide/README.md");
        String text = Files.readString(index);
        for (Path page : GuidePages.all()) {
            boolean isOne = page.startsWith("docs") && !page.equals(index);
            assertTrue(!isOne || text.contains("](" + page.getFileName() + ")"), page + " is not in " + index);
        }
    }

    /** Whole scenes as they are; parts of scenes, which begin with a key, in a scene that has nothing else. */
    @Test
    void everyBlockOfJsonIsASceneOrAPartOfOne() throws IOException {
        int whole = 0;
        int parts = 0;
        for (Path page : pages()) {
            for (String block : GuidePages.blocks(page, "json")) {
                boolean isWhole = block.startsWith("{");
                String text = isWhole ? block : inAFrame(page, block);
                Scene scene = SceneReader.readString(text, Path.of("textures"), page.toString());
                assertTrue(scene.width() > 0);
                whole += isWhole ? 1 : 0;
                parts += isWhole ? 0 : 1;
            }
        }
        assertTrue(whole > 0 && parts > 10, whole + " scenes and " + parts + " parts");
    }

    private static String inAFrame(Path page, String block) {
        ObjectNode frame = (ObjectNode) JSON.readTree(FRAME);
        JsonNode part;
        try {
            part = JSON.readTree("{" + block + "}");
        } catch (RuntimeException e) {
            throw new AssertionError(page + ": " + block, e);
        }
        part.properties().forEach(p -> frame.set(p.getKey(), p.getValue()));
        return frame.toString();
    }

    @Test
    void theSceneThatIsExplainedIsTheFileThatIsRendered() throws IOException {
        String file = Files.readString(Path.of("docs/guide/pictures/example.json"));
        assertTrue(GuidePages.blocks(Path.of("docs/guide/scene-by-example.md"), "json")
                .contains(file));
        String swatches = Files.readString(Path.of("docs/guide/pictures/swatches.json"));
        String shown =
                GuidePages.blocks(Path.of("docs/guide/materials.md"), "json").get(0);
        for (String line : shown.lines().filter(l -> l.contains("\"type\"")).toList()) {
            assertTrue(swatches.contains(line.strip().replaceFirst(",$", "")), line);
        }
    }
}

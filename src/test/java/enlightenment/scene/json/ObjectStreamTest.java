package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.geometry.Sphere;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.SceneObject;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Objects are bound while the text is read: wherever they stand in it, the scene and its problems are the same. */
class ObjectStreamTest {
    private static final List<String> MISTAKES = List.of(
            "\"radius\": 1.5 / \"radius\": -1.5",
            "\"texture\": \"checks\" / \"texture\": \"chucks\"",
            "\"material\": \"chrome\" },\n / \"material\": \"crome\" },\n",
            "\"indexOfRefraction\": 1.5 / \"indexOfRefraction\": \"1.5\"",
            "\"file\": \"ice.png\" / \"file\": \"fire.png\"",
            "\"name\": \"rod\" / \"name\": \"dish\"",
            "\"faces\": [\"ice\", / \"faces\": [\"steam\",",
            "\"seed\": 99 / \"sead\": 99",
            "\"part\": \"upper\" / \"part\": \"uper\"",
            "\"name\": \"other\" / \"name\": \"one\"",
            "\"scale\": 0.5 / \"scale\": 0",
            "\"group\": \"pair\" / \"group\": \"pear\"",
            "\"priority\": -2 / \"priority\": -2, \"priority\": 3",
            "\"capped\": false, \"material\": { / \"capped\": null, \"capped\": true, \"material\": {",
            "/objects/0/center/1 / /objects/10/center/1",
            "\"frames\": 11 / \"frames\": 0");

    @TempDir
    Path folder;

    private static final List<String> KEYS = List.of(
            "name",
            "image",
            "camera",
            "shading",
            "display",
            "meshes",
            "textures",
            "materials",
            "groups",
            "lights",
            "objects",
            "render",
            "animation");

    /** The document with its parts in another order. */
    private static String inOrder(List<String> keys, String document) {
        List<String> parts = new ArrayList<>();
        for (String key : keys) {
            int start = document.indexOf("\n  \"" + key + "\"");
            int end = document.indexOf("\n  \"", start + 1);
            String part = document.substring(start, end < 0 ? document.lastIndexOf('}') : end)
                    .stripTrailing();
            parts.add(part.endsWith(",") ? part.substring(0, part.length() - 1) : part);
        }
        return "{" + String.join(",", parts) + "\n}\n";
    }

    private static List<List<String>> orders() {
        List<List<String>> orders = new ArrayList<>();
        Random random = new Random(8);
        for (int i = 0; i < 40; i++) {
            List<String> keys = new ArrayList<>(KEYS);
            Collections.shuffle(keys, random);
            orders.add(keys);
        }
        return orders;
    }

    private Scene read(String json, OptionalInt frame) {
        return SceneReader.readBytes(
                json.getBytes(StandardCharsets.UTF_8), Documents.withImage(folder), "scene.json", frame);
    }

    @Test
    void theSceneDoesNotDependOnTheOrderOfItsParts() {
        String animated = Documents.edited(
                "\"tracks\": [",
                "\"tracks\": [{ \"target\": \"/materials/glass/transparency\", \"keys\": { \"0\": 0, \"10\": 1 } },"
                        + "{ \"target\": \"/textures/checks/scale\", \"keys\": { \"0\": 1, \"10\": 11 } },"
                        + "{ \"target\": \"/groups/pair/0/radius\", \"keys\": { \"0\": 1, \"10\": 2 } },"
                        + "{ \"target\": \"/objects/9/transform/1/rotate/1\", \"keys\": { \"0\": 0, \"10\": 90 } },"
                        + "{ \"target\": \"/objects/5/rotation/2\", \"keys\": { \"0\": 0, \"10\": 90 } },");
        for (OptionalInt frame : List.of(OptionalInt.empty(), OptionalInt.of(3), OptionalInt.of(10))) {
            Scene expected = read(animated, frame);
            assertEquals(13, expected.objects().size());
            for (List<String> keys : orders()) {
                Scene found = read(inOrder(keys, animated), frame);
                assertEquals(expected, found, () -> keys.toString());
                assertSame(
                        found.materials().get("chrome"), found.objects().get(1).material());
                assertSame(
                        found.textures().get("ice"),
                        found.objects().get(0).material().color());
            }
        }
        Sphere ball =
                (Sphere) read(animated, OptionalInt.of(3)).objects().get(0).shape();
        assertEquals(1.3, ball.center().y().doubleValue());
        assertNotEquals(
                read(animated, OptionalInt.of(3)).objects(),
                read(animated, OptionalInt.of(4)).objects());
    }

    @Test
    void itsProblemsDoNotDependOnTheOrderOfItsPartsEither() {
        Random random = new Random(9);
        Set<String> told = new HashSet<>();
        for (List<String> keys : orders()) {
            String document = Documents.EVERYTHING;
            for (String mistake : MISTAKES) {
                int cut = mistake.indexOf(" / ");
                String replaced = document.replace(mistake.substring(0, cut), mistake.substring(cut + 3));
                document = random.nextInt(3) == 0 ? replaced : document;
            }
            if (document.equals(Documents.EVERYTHING)) {
                continue;
            }
            List<Problem> expected = Documents.problems(document, Documents.withImage(folder));
            List<Problem> found = Documents.problems(inOrder(keys, document), folder);
            assertEquals(sorted(expected), sorted(found), () -> keys.toString());
            for (int i = 1; i < found.size(); i++) {
                assertTrue(found.get(i - 1).line() <= found.get(i).line());
            }
            told.addAll(sorted(found));
        }
        assertTrue(told.size() >= MISTAKES.size(), told.toString());
    }

    private static List<String> sorted(List<Problem> problems) {
        return problems.stream()
                .map(p -> p.pointer() + ": " + p.message().replaceAll("line \\d+, column \\d+", "line, column"))
                .sorted()
                .toList();
    }

    @Test
    void ofTwoArraysOfObjectsTheLastCounts() {
        String first = "\"objects\": [{ \"type\": \"spear\" }, 7, []], \"lights\": [";
        List<Problem> problems =
                Documents.problems(Documents.edited("\"lights\": [", first), Documents.withImage(folder));
        assertEquals(
                List.of("/objects"), problems.stream().map(Problem::pointer).toList());
        String last = Documents.edited("\"render\": {", "\"objects\": [7], \"render\": {");
        assertEquals(
                Set.of("/objects", "/objects/0", "/animation/tracks/0/target"),
                Set.copyOf(Documents.problems(last, folder).stream()
                        .map(Problem::pointer)
                        .toList()));
        String none = Documents.edited("\"render\": {", "\"objects\": 7, \"render\": {");
        assertEquals(
                List.of("/objects", "/objects", "/animation/tracks/0/target"),
                Documents.problems(none, folder).stream().map(Problem::pointer).toList());
    }

    @Test
    void aTextThatIsNotJsonHasNoOtherProblems() {
        String json = Documents.edited("\"radius\": 1.5", "\"radius\": -1.5").replace("\"seed\": 99", "\"seed\": 099");
        List<Problem> problems = Documents.problems(json, Documents.withImage(folder));
        assertEquals(
                List.of("/render/seed"), problems.stream().map(Problem::pointer).toList());
    }

    @Test
    void tracksThatLeadToObjectsAreToldWhatIsThere() {
        for (String[] t : new String[][] {
            {"/objects", "there is an array of 12 values"},
            {"/objects/0", "there is an object"},
            {"/objects/0/center", "there is an array of 3 values"},
            {"/objects/8/material", "there is the text \\\"ice\\\""},
            {"/objects/12", "there is nothing"},
            {"/objects/00/radius", "there is nothing"},
            {"/objects/999999999999/radius", "there is nothing"}
        }) {
            String json = Documents.edited("/objects/0/center/1", t[0]);
            Problem problem = Documents.problem(json, Documents.withImage(folder));
            assertEquals("/animation/tracks/0/target", problem.pointer());
            assertTrue(problem.message().contains(t[1].replace("\\", "")), problem.message());
        }
    }

    @Test
    void ofManyProblemsTheFirstThousandAreToldAndTheOthersCounted() {
        String objects = String.join(",\n", Collections.nCopies(1500, "{ \"type\": \"sphere\", \"radius\": -1 }"));
        List<Problem> problems =
                Documents.problems(Documents.withObjects(objects).replace("\"width\": 4", "\"width\": 0"), folder);
        // Two that are missing and one that is wrong, for each.
        assertEquals(1001, problems.size());
        assertEquals("/image/width", problems.get(0).pointer());
        String rest = problems.get(1000).message();
        assertTrue(rest.contains("and ") && rest.contains(" more problems"), rest);
        long told = Long.parseLong(rest.replaceAll("\\D+", ""));
        assertEquals(1 + 1500 * told(objects), 1000 + told);
    }

    /** The number of problems of one object. */
    private long told(String objects) {
        String one = objects.substring(0, objects.indexOf(",\n"));
        return Documents.problems(Documents.withObjects(one), folder).size();
    }

    @Test
    void theListOfObjectsIsOneThatNobodyChanges() {
        List<SceneObject> objects = Documents.read(Documents.EVERYTHING, Documents.withImage(folder))
                .objects();
        assertEquals(List.copyOf(objects), objects);
        assertEquals(objects, List.copyOf(objects));
        assertEquals(List.copyOf(objects).hashCode(), objects.hashCode());
        org.junit.jupiter.api.Assertions.assertThrows(UnsupportedOperationException.class, () -> objects.remove(0));
        org.junit.jupiter.api.Assertions.assertThrows(
                UnsupportedOperationException.class, () -> objects.set(0, objects.get(1)));
    }
}

package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.SceneException.Problem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class SceneErrorsTest {
    private static final String SPHERE =
            "{\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1, \"material\": {\"type\": \"matte\", \"color\": \"red\"}}";

    @TempDir
    Path folder;

    static Stream<BadDocuments.Edit> edits() {
        return Stream.of(BadDocuments.FOR_THE_SCHEMA_TOO, BadDocuments.FOR_THE_READER)
                .flatMap(List::stream);
    }

    @ParameterizedTest
    @MethodSource("edits")
    void eachMistakeIsToldOnceAtItsPlace(BadDocuments.Edit edit) {
        List<Problem> problems = Documents.problems(edit.document(), Documents.withImage(folder));
        Problem problem = problems.stream()
                .filter(p -> p.pointer().equals(edit.pointer()))
                .findFirst()
                .orElseThrow(() -> new AssertionError(problems.toString()));
        assertTrue(problem.message().contains(edit.says()), problem.message());
        assertTrue(problem.line() >= 1 && problem.column() >= 1, problem.toString());
        // A key with a wrong name is also one that is missing, if it must be there; nothing else causes more.
        assertEquals(1, problems.size(), problems::toString);
    }

    @Test
    void theUneditedDocumentHasNoProblems() {
        Documents.read(Documents.EVERYTHING, Documents.withImage(folder));
    }

    @Test
    void aPlaceIsTheFirstCharacterOfTheValue() {
        String json = Documents.EVERYTHING.replace("\"radius\": 1.25", "\"radius\": -1.25");
        Problem problem = Documents.problem(json, Documents.withImage(folder));
        String[] lines = json.split("\n");
        assertTrue(lines[problem.line() - 1].startsWith("-1.25", problem.column() - 1), problem.toString());
        assertEquals(
                "scene.json:" + problem.line() + ":" + problem.column()
                        + ": /objects/5/radius: must be a number greater than 0, not -1.25",
                problem.toString());
    }

    @Test
    void placesAreRightInEveryKindOfValueAndWithEveryKindOfLineEnd() {
        for (String end : new String[] {"\n", "\r\n", "\r"}) {
            for (String value : new String[] {"\"text\"", "true", "null", "{}", "[1, 2]"}) {
                String json = Documents.withObjects(
                        end + "// comment" + end + "  {\"type\": \"box\", \"min\": [0, 0, 0]," + end + "\t \"max\": "
                                + value + "," + end + "\"material\": {\"type\": \"matte\", \"color\": \"#000000\"}}");
                Problem problem = Documents.problem(json, folder);
                assertEquals("/objects/0/max", problem.pointer());
                assertEquals(4, problem.line());
                assertEquals(10, problem.column(), value);
            }
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "\"radius\": 0x1p3 | `\"0x1p3\" is not a number; expected a decimal number`",
                "\"radius\": 1d | `\"1d\" is not a number`",
                "\"radius\": 01 | `\"01\" is not a number`",
                "\"radius\": .5 | `\".5\" is not a number`",
                "\"radius\": 5. | `\"5.\" is not a number`",
                "\"radius\": +5 | `\"+5\" is not a number`",
                "\"radius\": 1e | `\"1e\" is not a number`",
                "\"radius\": --1 | `\"--1\" is not a number`",
                "\"radius\": nan | `\"nan\" needs double quotes`",
                "\"radius\": True | `\"True\" needs double quotes`",
                "radius: 1.5 | `\"radius\" needs double quotes`",
                "\"radius\" 1.5 | `found '1', expected a colon`",
                "\"radius\": , \"x\": 1 | `found ',' where a value should stand`",
                "\"radius\": 'a' | `where a value should stand; a text needs double quotes`",
                "\"radius\": \"a | `found 'r', expected a comma`",
                "\"radius\": 1 \"x\": 2 | `found '\"', expected a comma`",
                "\"radius\": 1 2 | `found '2', expected a comma`",
                "\"radius\": [1, ] | `found ']' where a value should stand`",
                "\"radius\": [1 } | `found '}', expected ']'`",
                "\"radius\": 1, } | `found '}', expected a key in double quotes`",
            })
    void whatIsNotJsonIsShown(String replacement, String says) {
        Problem problem = Documents.problem(Documents.edited("\"radius\": 1.25", replacement), folder);
        assertTrue(problem.message().contains(says), problem.message());
        assertTrue(problem.pointer().startsWith("/objects/5"), problem.toString());
        assertTrue(!problem.message().contains("Jackson") && !problem.message().contains("Feature"), problem.message());
        assertEquals(46, problem.line(), problem.toString());
    }

    @Test
    void textsThatEndTooEarlyOrTooLateAreRefused() {
        String whole = Documents.withObjects("");
        for (int length = 1; length < whole.length(); length++) {
            String cut = whole.substring(0, length);
            Problem problem = Documents.problem(cut, folder);
            assertTrue(
                    problem.message().contains("ends too early")
                            || problem.message().contains("needs double quotes"),
                    () -> cut + ": " + problem);
        }
        assertTrue(Documents.problem(whole + "1", folder).message().contains("after the end"));
        assertTrue(Documents.problem(whole + "}", folder).message().contains("not JSON"));
    }

    @Test
    void aBrokenMeshFileIsToldWithItsNameAndLine() throws Exception {
        Documents.withImage(folder);
        Files.writeString(folder.resolve("gem.obj"), Documents.GEM.replace("f 3 5 4", "f 3 5 44"));
        List<Problem> problems = Documents.problems(Documents.EVERYTHING, folder);
        assertEquals(
                List.of("/meshes/gem/file", "/objects/10/file"),
                problems.stream().map(Problem::pointer).toList());
        for (Problem problem : problems) {
            assertTrue(problem.message().contains(folder.resolve("gem.obj") + ": line 10"), problem.message());
            assertTrue(problem.line() >= 1 && problem.column() >= 1, problem.toString());
        }
    }

    @Test
    void aGroupInItselfIsToldWithItsChain() {
        String json =
                "{\"groups\": {\"a\": [{\"type\": \"group\", \"group\": \"b\"}], \"b\": [{\"type\": \"group\", \"group\": \"c\"}],"
                        + " \"c\": [{\"type\": \"group\", \"group\": \"b\"}]},"
                        + Documents.withObjects("{\"type\": \"group\", \"group\": \"a\"}")
                                .substring(1);
        Problem problem = Documents.problem(json, folder);
        assertEquals("/groups/c/0/group", problem.pointer());
        assertEquals("the group \"b\" lies in itself: \"b\" in \"c\" in \"b\"", problem.message());
        assertTrue(problem.line() >= 1 && problem.column() >= 1, problem.toString());
    }

    @Test
    void groupsThatMultiplyBeyondMeasureAreRefusedBeforeTheyArePlaced() {
        StringBuilder groups = new StringBuilder("\"g0\": [" + SPHERE + "]");
        for (int i = 1; i <= 4; i++) {
            String one = "{\"type\": \"group\", \"group\": \"g" + (i - 1) + "\"}";
            groups.append(", \"g" + i + "\": [" + String.join(", ", Collections.nCopies(3000, one)) + "]");
        }
        String json = "{\"groups\": {" + groups + "},"
                + Documents.withObjects("{\"type\": \"group\", \"group\": \"g4\"}")
                        .substring(1);
        List<Problem> problems = Documents.problems(json, folder);
        assertTrue(
                problems.stream()
                        .anyMatch(p -> p.pointer().equals("/objects/0/group")
                                && p.message().contains("places too much")),
                problems.toString());
    }

    /** Sixteen groups may lie in each other, whichever is read first. */
    @Test
    void groupsLieInEachOtherOnlySoDeep() {
        for (int deep : new int[] {16, 17}) {
            for (int first : new int[] {1, deep - 3, deep}) {
                StringBuilder groups = new StringBuilder();
                for (int i = 1; i <= deep; i++) {
                    String inside = i < deep ? "{\"type\": \"group\", \"group\": \"g" + (i + 1) + "\"}" : "";
                    groups.append(i > 1 ? ", " : "").append("\"g" + i + "\": [" + inside + "]");
                }
                String objects = "{\"type\": \"group\", \"group\": \"g" + first
                        + "\"}, {\"type\": \"group\", \"group\": \"g1\"}";
                String json = "{\"groups\": {" + groups + "},"
                        + Documents.withObjects(objects).substring(1);
                if (deep <= 16) {
                    Documents.read(json, folder);
                } else {
                    Problem problem = Documents.problem(json, folder);
                    assertTrue(problem.message().contains("more than 16 deep"), problem.message());
                }
            }
        }
    }

    @Test
    void aBoxInAGroupIsNotRotated() {
        String json = "{\"groups\": {\"g\": [{\"type\": \"box\", \"min\": [0, 0, 0], \"max\": [1, 2, 3],"
                + " \"material\": {\"type\": \"matte\", \"color\": \"#000\"}}]},"
                + Documents.withObjects(
                                "{\"type\": \"group\", \"group\": \"g\", \"transform\": [{\"rotate\": [0, 30, 0]}]}")
                        .substring(1);
        Problem problem = Documents.problem(json, folder);
        assertEquals("/objects/0/transform", problem.pointer());
        assertTrue(problem.message().contains("box"), problem.message());
        Documents.read(json.replace("[0, 30, 0]", "[0, 90, 0]"), folder);
    }

    @Test
    void aDocumentThatIsNoObjectIsRefused() {
        for (String json : new String[] {"[]", "3", "\"scene\"", "null"}) {
            Problem problem = Documents.problem(json, folder);
            assertEquals("", problem.pointer());
            assertTrue(problem.message().startsWith("must be a scene, an object"), problem.message());
        }
    }

    @Test
    void deepNestingAndLongNumbersAreRefused() {
        String deep = "[".repeat(100_000);
        assertTrue(Documents.problem(deep, folder).message().contains("100 levels"));
        String number = "9".repeat(2001);
        Problem problem = Documents.problem(Documents.edited("1.25", number), Documents.withImage(folder));
        assertTrue(problem.message().contains("has 2001 digits"), problem.message());
        String longer = "1" + "0".repeat(10_000_000);
        Problem far = Documents.problem(Documents.edited("1.25", longer), folder);
        assertTrue(far.message().contains("a number may have 5000 characters"), far.message());
        assertEquals("/objects/5/radius", far.pointer());
    }

    @Test
    void aFileThatIsNoImageIsRefused() throws Exception {
        Documents.withImage(folder);
        Files.writeString(folder.resolve("ice.png"), "GIF89a......");
        Problem problem = Documents.problem(Documents.EVERYTHING, folder);
        assertEquals("/textures/ice/file", problem.pointer());
        assertTrue(problem.message().contains("neither PNG, JPEG, BMP, PFM, HDR nor EXR"), problem.message());
        Files.writeString(folder.resolve("ice.png"), "");
        assertTrue(Documents.problem(Documents.EVERYTHING, folder).message().contains("is not an image"));
        Files.writeString(folder.resolve("ice.png"), "BM and so on");
        Documents.read(Documents.EVERYTHING, folder);
    }

    @Test
    void aCubeNeedsAMaterialOrFaces() {
        Problem problem = Documents.problem(
                Documents.withObjects("{\"type\": \"cube\", \"center\": [0, 0, 0], \"radius\": 1}"), folder);
        assertEquals("/objects/0/material", problem.pointer());
        assertTrue(problem.message().contains("or \"faces\""), problem.message());
    }

    @Test
    void aWrongMaterialIsNotToldAgainWhereItIsUsed() {
        String json = Documents.edited("\"indexOfRefraction\": 1.5", "\"indexOfRefraction\": -1.5");
        assertEquals(
                "/materials/glass/indexOfRefraction",
                Documents.problem(json, Documents.withImage(folder)).pointer());
    }

    @Test
    void namesWithSlashesAndTildesAreEscapedInPointers() {
        String json = Documents.withObjects("")
                .replaceFirst("\\{", "{\"materials\": {\"a/b~c\": {\"type\": \"matte\", \"color\": 3}},");
        assertEquals("/materials/a~1b~0c/color", Documents.problem(json, folder).pointer());
    }
}

package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Characters that a scene file must not have where they stand: told by what they are, in words of ours. */
class OddCharactersTest {
    @TempDir
    Path folder;

    private String told(String json) {
        Problem problem = Documents.problem(json, folder);
        for (String theirs : List.of("CTRL-CHAR", "code", "backslash to be included", "Unrecognized", "Illegal")) {
            assertFalse(problem.message().contains(theirs), problem.message());
        }
        assertTrue(problem.line() >= 1 && problem.column() >= 1, problem.toString());
        return problem.message();
    }

    private static String named(String name) {
        return Documents.withObjects("").replaceFirst("\\{", "{\"name\": \"" + name.replace("\\", "\\\\") + "\",");
    }

    @ParameterizedTest
    @CsvSource({
        "9,a tab,\\t",
        "8,a control character,\\u0008",
        "12,a control character,\\u000c",
        "27,a control character,\\u001b",
        "0,a control character,\\u0000"
    })
    void aControlCharacterWithinATextIsToldByHowItIsWritten(int character, String what, String escape) {
        String expected = "is not JSON: " + what + " in a text must be written as " + escape;
        assertEquals(expected, told(named("my" + (char) character + " scene")));
        assertEquals(
                expected, told(Documents.withObjects("").replaceFirst("\\{", "{\"na" + (char) character + "me\": 1,")));
    }

    @Test
    void aTextThatDoesNotEndInItsLineIsToldAsSuchWhateverItsLastWord() {
        for (String end : new String[] {"\n", "\r\n", "\r"}) {
            assertEquals(
                    "is not JSON: a text does not end in its line; a double quote is missing",
                    told(named("my scene" + end)));
        }
    }

    @ParameterizedTest
    @CsvSource({"C:\\textures\\x.png,\\x", "C:\\Pictures\\ice.png,\\P", "my C:\\x scene,\\x", "50 \\% grey,\\%"})
    void aBackslashThatEscapesNothingIsToldWithWhatWouldDo(String text, String escape) {
        assertEquals(
                "is not JSON: " + escape
                        + " means nothing in a text: a backslash is written \\\\, and / does as well in the"
                        + " path of a file",
                told(named(text)));
    }

    @Test
    void aBackslashBeforeAUWithoutDigitsIsTheSame() {
        assertEquals(
                "is not JSON: \\u without four hexadecimal digits means nothing in a text: a backslash is written \\\\, and /"
                        + " does as well in the path of a file",
                told(named("C:\\users\\x.png")));
    }

    @Test
    void controlCharactersBetweenValuesAreToldByTheirNumbers() {
        String json = Documents.withObjects("");
        for (String odd : new String[] {"001b", "0007", "0085"}) {
            String character = Character.toString((char) Integer.parseInt(odd, 16));
            assertEquals(
                    "is not JSON: found the control character U+" + odd.toUpperCase(java.util.Locale.ROOT)
                            + ", which may stand only in a text, as \\u" + odd,
                    told(json.replaceFirst("\\{", "{" + character)));
        }
    }

    @ParameterizedTest
    @CsvSource({"UTF-16LE", "UTF-16BE", "UTF-32LE", "UTF-32BE"})
    void aTextInUtf16WithoutItsMarkIsToldAsWhatItIs(String encoding) {
        byte[] bytes = Documents.withObjects("").getBytes(Charset.forName(encoding));
        SceneException e = assertThrows(
                SceneException.class, () -> SceneReader.readBytes(bytes, folder, "x.json", OptionalInt.empty()));
        assertEquals(
                "is not JSON: found a character NUL, as texts in UTF-16 have them; a scene file must be a text in UTF-8",
                e.problems().get(0).message());
        assertEquals(1, e.problems().size());
    }

    @Test
    void aTextInUtf8IsNotToldToBeInUtf16() {
        byte[] bytes = Documents.withObjects("").getBytes(StandardCharsets.UTF_8);
        SceneReader.readBytes(bytes, folder, "x.json", OptionalInt.empty());
    }

    @Test
    void anEmptyNameIsToldAsSuch() {
        SceneException e = assertThrows(SceneException.class, () -> SceneReader.read(Path.of("")));
        assertEquals("the name of the scene file is empty", e.getMessage());
    }
}

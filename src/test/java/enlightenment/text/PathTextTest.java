package enlightenment.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PathTextTest {
    @TempDir
    Path folder;

    @Test
    void aNameThatTheLocaleHasNoLettersForIsToldWithWhatHelps() {
        for (String name : new String[] {"\u00fc.png", "\ufffd.png"}) {
            assertEquals(
                    "the name \"" + name + "\" cannot be expressed in this locale (US-ASCII); LC_ALL=C.UTF-8 helps",
                    PathText.reason(new InvalidPathException(name, "Malformed input"), StandardCharsets.US_ASCII));
        }
        assertEquals(
                "the name \"\u0141.png\" cannot be expressed in this locale (ISO-8859-1); LC_ALL=C.UTF-8 helps",
                PathText.reason(
                        new InvalidPathException("\u0141.png", "Malformed input"), StandardCharsets.ISO_8859_1));
    }

    @Test
    void whatNoLocaleTakesForAPathIsToldAsSuch() {
        InvalidPathException e = assertThrows(InvalidPathException.class, () -> Path.of("a\0b"));
        assertEquals("is not a path: \"a?b\"", PathText.reason(e, StandardCharsets.US_ASCII));
        assertEquals("is not a path: \"a?b\"", PathText.reason(e, StandardCharsets.UTF_8));
        assertEquals("is not a path: \"a?b\"", PathText.reason(e));
        InvalidPathException half = new InvalidPathException("\ud800", "Malformed input");
        assertEquals("is not a path: \"?\"", PathText.reason(half, StandardCharsets.UTF_8));
    }

    @Test
    void aWorkingFolderThatTheLocaleHasNoLettersForIsToldWithWhatHelps() {
        assertEquals(
                Optional.of("the working folder \"/a/\ufffd\ufffd\" cannot be expressed in this locale (US-ASCII);"
                        + " LC_ALL=C.UTF-8 helps"),
                PathText.problemOfWorkingFolder("/a/\ufffd\ufffd", StandardCharsets.US_ASCII));
        assertEquals(
                Optional.of("the working folder \"/a/\ufffd\" cannot be expressed in this locale (UTF-8)"),
                PathText.problemOfWorkingFolder("/a/\ufffd", StandardCharsets.UTF_8));
    }

    @Test
    void anyOtherWorkingFolderIsNoProblem() throws IOException {
        assertEquals(Optional.empty(), PathText.problemOfWorkingFolder());
        assertEquals(Optional.empty(), PathText.problemOfWorkingFolder("/a/b", StandardCharsets.US_ASCII));
        Path odd = folder.resolve("odd");
        try {
            odd = folder.resolve("\ufffd");
        } catch (InvalidPathException e) {
            // The locale of this test is itself such a one.
        }
        Files.createDirectory(odd);
        assertEquals(Optional.empty(), PathText.problemOfWorkingFolder(odd.toString(), StandardCharsets.UTF_8));
    }
}

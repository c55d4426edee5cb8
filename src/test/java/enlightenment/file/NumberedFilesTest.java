package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NumberedFilesTest {
    @TempDir
    Path folder;

    private static WholeFile.Content text(String s) {
        return out -> out.write(s.getBytes(StandardCharsets.UTF_8));
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void filesAreCountedWhateverTheirExtension() throws IOException {
        NumberedFiles files = new NumberedFiles(folder, "a");
        assertEquals(folder.resolve("a-1.x"), files.write("x", text("one")));
        assertEquals(folder.resolve("a-2.y"), files.write("y", text("two")));
        assertEquals("two", Files.readString(folder.resolve("a-2.y")));
    }

    @Test
    void theSameFilesGetTheSameNamesAgain() throws IOException {
        for (int i = 0; i < 2; i++) {
            NumberedFiles files = new NumberedFiles(folder, "a");
            files.write("x", text("one"));
            files.write("x", text("two"));
        }
        assertEquals(List.of("a-1.x", "a-2.x"), names());
    }

    @Test
    void otherFilesStayAndAreSkipped() throws IOException {
        for (String other : List.of("", "on", "one and more", "two")) {
            Files.writeString(folder.resolve("a-1.x"), other);
            Path written = new NumberedFiles(folder, "a").write("x", text("one"));
            assertEquals(folder.resolve("a-2.x"), written);
            assertEquals(other, Files.readString(folder.resolve("a-1.x")));
            Files.delete(written);
        }
    }

    @Test
    void foldersAndBrokenLinksAreSkipped() throws IOException {
        Files.createDirectory(folder.resolve("a-1.x"));
        Files.createSymbolicLink(folder.resolve("a-2.x"), folder.resolve("absent"));
        assertEquals(folder.resolve("a-3.x"), new NumberedFiles(folder, "a").write("x", text("one")));
        assertEquals(List.of("a-1.x", "a-2.x", "a-3.x"), names());
    }

    @Test
    void filesThatCannotBeWrittenAreNamed() {
        NumberedFiles files = new NumberedFiles(folder.resolve("absent"), "a");
        String message = assertThrows(IOException.class, () -> files.write("x", text("one")))
                .getMessage();
        assertEquals(true, message.contains("a-1.x"), message);
    }
}

package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilePlaceTest {
    @TempDir
    Path temporary;

    private Path folder;

    @BeforeEach
    void real() throws IOException {
        folder = temporary.toRealPath();
    }

    @Test
    void linksAreFollowedWhetherOrNotTheyLeadToAFile() throws IOException {
        Path far = Files.createDirectories(folder.resolve("far/away"));
        Path door = Files.createSymbolicLink(folder.resolve("door"), far);
        // From the linked folder, .. leads to where it lies and not back to where it is called.
        assertEquals(folder.resolve("far/new"), FilePlace.of(door.resolve("../new")));
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("door/new"));
        assertEquals(far.resolve("new"), FilePlace.of(link));
        assertTrue(FilePlace.same(link, far.resolve("new")));
        Files.createFile(far.resolve("new"));
        assertEquals(far.resolve("new"), FilePlace.of(link));
        assertFalse(FilePlace.same(link, folder.resolve("new")));
    }

    @Test
    void hardLinksAreOneFile() throws IOException {
        Path a = Files.createFile(folder.resolve("a"));
        Path b = Files.createLink(folder.resolve("b"), a);
        assertTrue(FilePlace.same(a, b));
        assertFalse(FilePlace.same(a, Files.createFile(folder.resolve("c"))));
        assertFalse(FilePlace.same(a, folder.resolve("d")));
    }

    @Test
    void foldersThatAreMissingAreTakenAsTheyAreSpelled() throws IOException {
        assertEquals(folder.resolve("no/a"), FilePlace.of(folder.resolve("no/sub/../a")));
        assertTrue(FilePlace.same(folder.resolve("no/a"), folder.resolve("no/./a")));
    }

    @Test
    void linksInACircleAreAFailure() throws IOException {
        Path a = Files.createSymbolicLink(folder.resolve("a"), Path.of("b"));
        Files.createSymbolicLink(folder.resolve("b"), Path.of("a"));
        String reason =
                assertThrows(FileSystemException.class, () -> FilePlace.of(a)).getReason();
        assertEquals("its links lead in a circle", reason);
    }

    @Test
    void newNamesThatDifferInCaseOrInTheMakingOfAccentsAreWhatTheFileSystemSays() throws IOException {
        for (String[] names : new String[][] {{"a.png", "A.png"}, {"\u00fc", "u\u0308"}}) {
            Path one = folder.resolve(names[0]);
            Path two = folder.resolve(names[1]);
            boolean said = FilePlace.same(one, two);
            Files.createFile(one);
            assertEquals(Files.exists(two), said);
            Files.delete(one);
        }
        assertEquals(0, folder.toFile().list().length);
    }
}

package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Pipe;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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

    /** As what {@code /dev/stdout} leads to where the output goes into a pipe: it exists, and its links lead to no path. */
    @Test
    void aPipeOfThisProcessIsTakenAsItIsSpelledAndWrittenInto() throws IOException {
        Path descriptors = Path.of("/proc/self/fd");
        assumeTrue(Files.isDirectory(descriptors));
        Set<Path> before = pipes(descriptors);
        Pipe pipe = Pipe.open();
        try (Pipe.SourceChannel source = pipe.source();
                Pipe.SinkChannel sink = pipe.sink()) {
            assertTrue(sink.isOpen());
            Set<Path> after = pipes(descriptors);
            after.removeAll(before);
            Path end = after.stream().findFirst().orElseThrow();
            assertEquals(end, FilePlace.of(end));
            assertTrue(FilePlace.same(end, end));
            assertFalse(FilePlace.same(end, folder.resolve("a")));
            WholeFile.write(end, "through");
            ByteBuffer read = ByteBuffer.allocate(7);
            source.read(read);
            assertEquals("through", new String(read.array(), StandardCharsets.US_ASCII));
        }
    }

    private static Set<Path> pipes(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(FilePlaceTest::isPipe).collect(Collectors.toSet());
        }
    }

    private static boolean isPipe(Path descriptor) {
        try {
            return Files.readSymbolicLink(descriptor).toString().startsWith("pipe:");
        } catch (IOException e) {
            return false;
        }
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
            Path one;
            Path two;
            try {
                one = folder.resolve(names[0]);
                two = folder.resolve(names[1]);
            } catch (InvalidPathException e) {
                // Where the user's language has no accents, names have none.
                continue;
            }
            boolean said = FilePlace.same(one, two);
            Files.createFile(one);
            assertEquals(Files.exists(two), said);
            Files.delete(one);
        }
        assertEquals(0, folder.toFile().list().length);
    }
}

package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    @TempDir
    Path folder;

    private void assertOnlyFile(String name, String content) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(name, files.map(f -> f.getFileName().toString()).reduce("", String::concat));
        }
        assertEquals(content, Files.readString(folder.resolve(name)));
    }

    private static String failure(Path file) {
        String message = assertThrows(
                        IOException.class, () -> WholeFile.write(file, out -> out.write(new byte[1 << 20])))
                .getMessage();
        assertTrue(message.startsWith("cannot write " + file + ": "), message);
        return message.substring(("cannot write " + file + ": ").length());
    }

    @Test
    void aFileIsCreatedAndReplaced() throws IOException {
        Path file = folder.resolve("a.txt");
        WholeFile.write(file, out -> out.write("one".getBytes()));
        assertOnlyFile("a.txt", "one");
        WholeFile.write(file, out -> out.write("two".getBytes()));
        assertOnlyFile("a.txt", "two");
    }

    @Test
    void aFailureLeavesTheOldFileAndNothingElse() throws IOException {
        Path file = folder.resolve("a.txt");
        Files.writeString(file, "old");
        IOException e = assertThrows(
                IOException.class,
                () -> WholeFile.write(file, out -> {
                    out.write(new byte[1 << 20]);
                    throw new IOException("No space left on device");
                }));
        assertEquals("cannot write " + file + ": No space left on device", e.getMessage());
        assertOnlyFile("a.txt", "old");
        assertThrows(
                IllegalStateException.class,
                () -> WholeFile.write(file, out -> {
                    throw new IllegalStateException();
                }));
        assertOnlyFile("a.txt", "old");
    }

    @Test
    void aNewFileCanBeReadByThoseWhoMayReadOtherNewFiles() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Path usual = folder.resolve("usual");
        Path ours = folder.resolve("ours");
        Files.writeString(usual, "x");
        WholeFile.write(ours, out -> out.write('x'));
        assertEquals(Files.getPosixFilePermissions(usual), Files.getPosixFilePermissions(ours));
    }

    @Test
    void foldersAreNamedWhenTheyAreMissingOrInTheWay() throws IOException {
        assertEquals("it is a folder", failure(folder));
        assertEquals(
                "there is no folder " + folder.resolve("missing").toAbsolutePath(),
                failure(folder.resolve("missing/a.png")));
        Path file = Files.writeString(folder.resolve("file"), "x");
        assertEquals("there is no folder " + file.toAbsolutePath(), failure(file.resolve("a.png")));
    }

    @Test
    void aLinkIsFollowed() throws IOException {
        Path target = Files.writeString(folder.resolve("target"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("link"), target);
        WholeFile.write(link, out -> out.write('n'));
        assertTrue(Files.isSymbolicLink(link));
        assertEquals("n", Files.readString(target));
    }

    @Test
    void aLinkThatLeadsNowhereYetIsFollowedToo() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link"), Path.of("target"));
        WholeFile.write(link, "new");
        assertTrue(Files.isSymbolicLink(link));
        assertEquals("new", Files.readString(folder.resolve("target")));
    }

    @Test
    void anotherNameOfAFileKeepsWhatItHeld() throws IOException {
        Path one = Files.writeString(folder.resolve("one"), "old");
        Path other = Files.createLink(folder.resolve("other"), one);
        WholeFile.write(one, "new");
        assertEquals("old", Files.readString(other));
        assertEquals("new", Files.readString(one));
    }

    @Test
    void devicesAreWrittenDirectly() throws IOException {
        Path nothing = Path.of("/dev/null");
        assumeTrue(Files.exists(nothing));
        WholeFile.write(nothing, out -> out.write(new byte[1 << 20]));
        assertTrue(Files.exists(nothing) && !Files.isRegularFile(nothing));
    }

    @Test
    void aFullDeviceIsReported() {
        Path full = Path.of("/dev/full");
        assumeTrue(Files.isWritable(full));
        // The words are the system's, in the user's language.
        IOException e = assertThrows(IOException.class, () -> Files.write(full, new byte[1]));
        assertEquals(e.getMessage(), failure(full));
    }

    @Test
    void readOnlyPlacesAreReported() throws IOException {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Path locked = Files.createDirectory(folder.resolve("locked"));
        Path old = Files.writeString(folder.resolve("old"), "old");
        Files.setPosixFilePermissions(old, PosixFilePermissions.fromString("r--r--r--"));
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("r-xr-xr-x"));
        assumeTrue(!Files.isWritable(locked), "the superuser may write everywhere");
        assertEquals("permission denied", failure(locked.resolve("a.png")));
        assertEquals("it is read-only", failure(old));
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
}

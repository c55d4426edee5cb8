package enlightenment.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

@Timeout(600)
class InputFileTest {
    private static final byte[] CONTENT = {1, 2, 3, 4, 5};

    @TempDir
    Path folder;

    private static String failure(Executable reading) {
        return assertThrows(IOException.class, reading).getMessage();
    }

    private Path file() throws IOException {
        return Files.write(folder.resolve("a"), CONTENT);
    }

    @Test
    void aFolderIsRefusedByItsName() {
        String message = folder + ": it is a folder";
        assertEquals(message, failure(() -> InputFile.open(folder)));
        assertEquals(message, failure(() -> InputFile.bytes(folder)));
        assertEquals(message, failure(() -> InputFile.start(folder, 3)));
    }

    @Test
    void aFileIsReadAsAWholeOrItsStart() throws IOException {
        Path file = file();
        assertArrayEquals(CONTENT, InputFile.bytes(file));
        assertArrayEquals(new byte[] {1, 2, 3}, InputFile.start(file, 3));
        assertArrayEquals(CONTENT, InputFile.start(file, 9));
        assertThrows(NoSuchFileException.class, () -> InputFile.bytes(folder.resolve("no")));
    }

    @Test
    void whatFailsWithoutANameGetsOneAndWhatHasOneKeepsIt() {
        Path file = folder.resolve("a");
        IOException nameless = new IOException("Input/output error");
        IOException named = FileFailure.named(file, nameless);
        assertEquals(file + ": Input/output error", named.getMessage());
        assertSame(nameless, named.getCause());
        IOException other = new NoSuchFileException("b");
        assertSame(other, FileFailure.named(file, other));
        assertSame(named, FileFailure.named(folder, named));
    }

    /** Reading its own memory at address 0 fails on Linux, whoever does it; the words are the system's, in the user's language. */
    @Test
    void aFailureWhileReadingNamesTheFile() {
        Path memory = Path.of("/proc/self/mem");
        assumeTrue(Files.isReadable(memory));
        String words = failure(() -> {
            try (InputStream in = new FileInputStream(memory.toFile())) {
                in.read();
            }
        });
        assertFalse(words.contains(memory.toString()), words);
        assertEquals(memory + ": " + words, failure(() -> InputFile.start(memory, 1)));
        assertEquals(memory + ": " + words, failure(() -> {
            try (InputStream in = InputFile.open(memory)) {
                in.read();
            }
        }));
    }

    @Test
    void aDeviceWithoutAnEndIsNotReadAsAWholeButItsStartIs() throws IOException {
        Path zero = Path.of("/dev/zero");
        assumeTrue(Files.exists(zero));
        assertEquals(
                "/dev/zero: it is a device, and what it gives may have no end", failure(() -> InputFile.bytes(zero)));
        assertArrayEquals(new byte[7], InputFile.start(zero, 7));
    }

    @Test
    void aPipeIsReadToItsEnd() throws Exception {
        Path pipe = folder.resolve("pipe");
        NamedPipe.writing(pipe, CONTENT);
        assertArrayEquals(CONTENT, InputFile.bytes(pipe));
    }

    @Test
    void ofFailuresOfFilesOnlyTheWordsAreToldAndOfOthersTheKindToo() {
        IOException full = new IOException("No space left on device");
        assertEquals("No space left on device", FileFailure.told(full));
        assertEquals("No space left on device", FileFailure.told(new UncheckedIOException(full)));
        assertEquals("it cannot be kept", FileFailure.told(new UncheckedIOException("it cannot be kept", full)));
        assertEquals("java.lang.IllegalStateException: oh", FileFailure.told(new IllegalStateException("oh")));
        assertEquals("java.io.IOException", FileFailure.told(new IOException()));
    }
}

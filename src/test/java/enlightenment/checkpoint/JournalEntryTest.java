package enlightenment.checkpoint;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.file.ContentHash;
import enlightenment.job.RenderIdentity;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Records with right checksums that no version writes. */
class JournalEntryTest {
    private static final RenderIdentity RENDER =
            new RenderIdentity(ContentHash.of(new byte[] {1}), "method raytrace, seed 1", "1.0");
    private static final RenderIdentity OTHER =
            new RenderIdentity(ContentHash.of(new byte[] {1}), "method raytrace, seed 2", "1.0");

    /** Key of the plan and kind. */
    private static final int HEAD = Long.BYTES + 1;

    @TempDir
    Path folder;

    private static CheckpointJournal open(Path file, RenderIdentity render) throws IOException {
        return CheckpointJournal.open(file, render, true, 0, (plan, record, place) -> {}, channel -> {});
    }

    /** A journal that ends with a record of this body; returns where the record begins. */
    private long write(Path file, byte[] body) throws IOException {
        Files.deleteIfExists(file);
        open(file, RENDER).close();
        long place = Files.size(file);
        JournalFormat.Header header = JournalFormat.Header.decode(Files.readAllBytes(file), 0);
        Files.write(file, header.record(body).array(), StandardOpenOption.APPEND);
        return place;
    }

    @Test
    void aRecordTooShortForPlanAndKindIsRefusedByNameAndTheFileIsLeftAsItIs() throws IOException {
        Path file = folder.resolve("short.ck");
        for (int length = 1; length < HEAD; length++) {
            long place = write(file, new byte[length]);
            byte[] before = Files.readAllBytes(file);
            String message = assertThrows(JournalException.class, () -> open(file, RENDER))
                    .getMessage();
            assertTrue(message.startsWith(file + ": "), message);
            assertTrue(message.contains("at byte " + place), message);
            assertArrayEquals(before, Files.readAllBytes(file));
        }
    }

    @Test
    void aRecordThatBecomesTooShortMeanwhileIsRefusedToo() throws IOException {
        Path file = folder.resolve("later.ck");
        try (CheckpointJournal journal = open(file, RENDER)) {
            long place = Files.size(file);
            JournalFormat.Header header = JournalFormat.Header.decode(Files.readAllBytes(file), 0);
            Files.write(file, header.record(new byte[HEAD - 1]).array(), StandardOpenOption.APPEND);
            assertThrows(JournalException.class, () -> journal.read(place));
        }
    }

    /** It holds no results, so it is begun anew, as one of another render without records is. */
    @Test
    void theJournalOfAnotherRenderWithShortRecordsIsBegunAnew() throws IOException {
        Path file = folder.resolve("other.ck");
        for (int length = 1; length < HEAD; length++) {
            write(file, new byte[length]);
            open(file, OTHER).close();
            JournalFormat.Header header = JournalFormat.Header.decode(Files.readAllBytes(file), 0);
            assertEquals("", header.difference(JournalFormat.Header.of(OTHER, 0)));
        }
    }

    @Test
    void randomRecordsOfEveryKindAndLengthAreReadOrRefused() throws IOException {
        Random random = new Random(3);
        Path file = folder.resolve("random.ck");
        for (int kind = 0; kind < 12; kind++) {
            for (int length = HEAD; length < HEAD + 80; length++) {
                byte[] body = new byte[length];
                random.nextBytes(body);
                body[Long.BYTES] = (byte) kind;
                write(file, body);
                for (RenderIdentity render : new RenderIdentity[] {RENDER, OTHER}) {
                    try {
                        open(file, render).close();
                    } catch (JournalException e) {
                        assertTrue(e.getMessage().startsWith(file.toString()), e.getMessage());
                    }
                }
            }
        }
    }
}

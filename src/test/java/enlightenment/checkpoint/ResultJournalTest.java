package enlightenment.checkpoint;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ResultJournalTest {
    @TempDir
    Path folder;

    @Test
    void whatWasKeptLastIsFoundAndNothingIsLeft() throws IOException {
        try (ResultJournal journal = new ResultJournal(2, folder)) {
            journal.keep(1, new byte[] {1, 2});
            journal.keep(0, new byte[] {3});
            journal.keep(1, new byte[] {4, 5, 6});
            assertArrayEquals(new byte[] {4, 5, 6}, journal.get(1));
            assertArrayEquals(new byte[] {3}, journal.get(0));
        }
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void aFolderThatCannotTakeResultsIsToldWithItsNameAndHowToGiveAnother() throws IOException {
        Path missing = folder.resolve("no");
        try (ResultJournal journal = new ResultJournal(1, missing)) {
            UncheckedIOException e = assertThrows(UncheckedIOException.class, () -> journal.keep(0, new byte[] {1}));
            assertEquals(
                    "results cannot be kept in the temporary folder " + missing
                            + " (java -Djava.io.tmpdir=FOLDER gives another): there is no such folder",
                    e.getMessage());
        }
    }
}

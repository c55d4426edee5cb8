package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.analysis.SyntheticRuns;
import enlightenment.measure.trade.TradeRun;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TradeJournalTest {
    private static final TradeRun ONE = SyntheticRuns.run("raytrace", 1.5, Long.MIN_VALUE, 1.0 / 3, 0.1);
    private static final TradeRun TWO = SyntheticRuns.run("cluster", 64, 7, 1e-9, 123.456);

    @TempDir
    Path folder;

    @Test
    void whatIsReadIsWhatWasWritten() throws IOException {
        Path file = folder.resolve("trade.csv");
        TradeJournal journal = TradeJournal.create(file);
        journal.add(ONE, 0);
        journal.add(TWO, 1e-10);
        assertEquals(List.of(ONE, TWO), TradeJournal.open(file).runs());
    }

    @Test
    void aLineThatWasCutShortIsDroppedAndTheNextOneIsWhole() throws IOException {
        Path file = folder.resolve("trade.csv");
        TradeJournal.create(file).add(ONE, 0);
        Files.writeString(file, Files.readString(file) + "ladder,cluster,4,10");
        TradeJournal again = TradeJournal.open(file);
        again.add(TWO, 0);
        assertEquals(List.of(ONE, TWO), TradeJournal.open(file).runs());
    }

    @Test
    void otherFilesAreRefusedWithThePlace() throws IOException {
        Path file = folder.resolve("trade.csv");
        Files.writeString(file, "a,b,c\n1,2,3\n");
        assertThrows(IOException.class, () -> TradeJournal.open(file));
        TradeJournal.create(file);
        Files.writeString(file, Files.readString(file) + "ladder,cluster,four\n");
        IOException e = assertThrows(IOException.class, () -> TradeJournal.open(file));
        assertTrue(e.getMessage().startsWith(file + ":2: "), e.getMessage());
    }
}

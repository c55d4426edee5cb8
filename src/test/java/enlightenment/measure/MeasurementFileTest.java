package enlightenment.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.measure.trade.Reference;
import enlightenment.measure.trade.TradeResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MeasurementFileTest {
    private static final Reference REFERENCE = new Reference(
            Optional.empty(),
            1.0 / 3,
            List.of(new Reference.Part("raytrace", 2, 1024, -1), new Reference.Part("cluster", 10, 64.5, -2)));

    private static final TradeResult.Conditions CONDITIONS =
            new TradeResult.Conditions(Map.of("processor", "a = b, c"), 0.1, 90.5, true);

    @TempDir
    Path folder;

    @Test
    void whatIsReadIsWhatWasWritten() throws IOException {
        Path file = Files.write(folder.resolve("measured.txt"), MeasurementFile.lines(REFERENCE, CONDITIONS));
        MeasurementFile.Content read = MeasurementFile.parse(file, Optional.empty());
        assertEquals(REFERENCE, read.reference());
        assertEquals(CONDITIONS, read.conditions());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "seconds=1",
                "reference.variance=much",
                "reference.variance=-1",
                "reference.variance=1\nreference.part=raytrace,2",
                "reference.variance=1\nunknown=1",
                "reference.variance=1\nno equals sign"
            })
    void aDamagedFileIsRefusedByName(String text) throws IOException {
        Path file = Files.writeString(folder.resolve("measured.txt"), text);
        IOException e = assertThrows(IOException.class, () -> MeasurementFile.parse(file, Optional.empty()));
        assertTrue(e.getMessage().startsWith(file + ": is not what the command trade wrote"), e.getMessage());
    }
}

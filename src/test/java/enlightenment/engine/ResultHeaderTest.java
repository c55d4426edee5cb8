package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.world.parts.RayCounters;
import java.nio.ByteBuffer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ResultHeaderTest {
    @ParameterizedTest
    @CsvSource({"0, false", "0, true", "1, false", "5, true", "4611686018427387903, true"})
    void lostSamplesAndDifferencesShareANumber(long lost, boolean differences) {
        ResultHeader header = new ResultHeader();
        header.add(7, false, 0);
        header.add(2, differences, lost);
        ByteBuffer out = ByteBuffer.allocate(ResultHeader.length(2));
        header.write(out, new RayCounters(2));
        assertEquals(0, out.remaining());
        assertEquals(9, ResultHeader.surveyRays(out.array()));
        assertEquals(lost, ResultHeader.lostSamples(out.array(), 2));
        assertEquals(differences, ResultHeader.samplesAreDifferences(out.array(), 2));
    }
}

package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class PlainProgressTest {
    private static final long MILLI = 1_000_000;
    private long now = 77;

    @Test
    void linesComeEveryTwoSecondsAndForetellByWhatWasDone() {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        PlainProgress progress = new PlainProgress(new PrintStream(err, true), () -> now);
        at(progress, 1_999, 10);
        at(progress, 2_000, 50);
        at(progress, 3_900, 60);
        at(progress, 4_000, 99);
        at(progress, 9_000, 200);
        // 50 of 200 in 2 s leave 6 s; 99 of 200 in 4 s leave 4.08 s.
        assertEquals("25 % done, 6 s left\n49 % done, 5 s left\n", err.toString(StandardCharsets.UTF_8));
    }

    private void at(PlainProgress progress, long millis, long done) {
        now = 77 + millis * MILLI;
        progress.progress(done, 200, () -> {
            throw new AssertionError("no picture is needed");
        });
    }
}

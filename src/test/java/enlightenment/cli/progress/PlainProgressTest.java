package enlightenment.cli.progress;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class PlainProgressTest {
    private static final long MILLI = 1_000_000;
    private long now = 77;
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private final PlainProgress progress = new PlainProgress(new PrintStream(err, true), () -> now);

    @Test
    void linesComeEveryTwoSecondsAndForetellByWhatWasDoneSinceTheFirstTile() {
        at(1_900, 10);
        at(2_000, 50);
        at(3_800, 60);
        at(4_000, 90);
        at(9_000, 200);
        // 80 in the 2.1 s since the first tile: 110 more take 2.9 s.
        assertEquals("25 % done\n45 % done, 3 s left\n", said());
    }

    /** Planning took a minute: that says nothing of the tiles. */
    @Test
    void whatCameBeforeTheFirstTileDoesNotCount() {
        at(60_000, 1);
        at(62_500, 51);
        assertEquals("0 % done\n25 % done, 8 s left\n", said());
    }

    @Test
    void nothingIsForetoldFromAFewTilesUnlessTheyTakeLong() {
        at(0, 1);
        at(3_000, 2);
        at(6_000, 3);
        assertEquals("1 % done\n1 % done\n", said());
        at(20_000, 3);
        // Two in 20 s: 197 more take 1970 s.
        assertEquals("1 % done\n1 % done\n1 % done, 1970 s left\n", said());
    }

    /** As previews do, which come before the first tile. */
    @Test
    void whileNothingIsFinishedNothingIsSaid() {
        at(10_000, 0);
        at(20_000, 0);
        assertEquals("", said());
    }

    /** As it is where the first picture was not as exact as asked. */
    @Test
    void aPictureThatIsRenderedOnceMoreIsForetoldByItself() {
        at(1_000, 10);
        at(5_000, 200);
        at(6_000, 20);
        // 60 in the 2.5 s since the new first tile: 120 more take 5 s.
        at(8_500, 80);
        assertEquals("10 % done\n40 % done, 5 s left\n", said());
    }

    private String said() {
        return err.toString(StandardCharsets.UTF_8);
    }

    private void at(long millis, long done) {
        now = 77 + millis * MILLI;
        progress.progress(done, 200, () -> {
            throw new AssertionError("no picture is needed");
        });
    }
}

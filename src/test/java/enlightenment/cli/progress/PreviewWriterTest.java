package enlightenment.cli.progress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class PreviewWriterTest {
    private static final Image IMAGE = new Image(1, 1, new float[3]);

    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private final Terminal terminal =
            new Terminal(null, new PrintStream(err, true, StandardCharsets.UTF_8), new ShutdownSignal());
    private final List<Image> written = Collections.synchronizedList(new ArrayList<>());
    private long now;

    private static final long SECOND = 1_000_000_000L;

    private void at(double seconds, PreviewWriter writer, long done) {
        now = (long) (seconds * SECOND);
        writer.progress(done, 10, () -> IMAGE);
        writer.finish();
    }

    @Test
    void aPictureIsWrittenAboutAsOftenAsAskedButNotTheFinishedOne() {
        PreviewWriter writer = new PreviewWriter(RenderProgress.NONE, 2, written::add, terminal, () -> now);
        at(1.9, writer, 0);
        assertEquals(0, written.size());
        at(2.1, writer, 0);
        at(2.2, writer, 1);
        at(4, writer, 2);
        assertEquals(1, written.size());
        at(4.2, writer, 3);
        assertEquals(2, written.size());
        at(9, writer, 10);
        assertEquals(2, written.size());
        assertSame(IMAGE, written.get(0));
    }

    @Test
    void slowWritingIsDoneLessOften() {
        PreviewWriter writer = new PreviewWriter(
                RenderProgress.NONE,
                1,
                image -> {
                    written.add(image);
                    now += SECOND;
                },
                terminal,
                () -> now);
        at(1, writer, 1);
        // Writing took a second: the next is due after twenty.
        at(20.9, writer, 2);
        assertEquals(1, written.size());
        at(21.1, writer, 3);
        assertEquals(2, written.size());
    }

    @Test
    void whatCannotBeWrittenIsToldOnceAndTheRenderGoesOn() {
        List<Long> heard = new ArrayList<>();
        PreviewWriter writer = new PreviewWriter(
                (done, total, soFar) -> heard.add(done),
                1,
                image -> {
                    throw new IOException("disk full");
                },
                terminal,
                () -> now);
        at(2, writer, 1);
        at(4, writer, 2);
        assertEquals("enlightenment: no more previews: disk full\n", err.toString(StandardCharsets.UTF_8));
        assertEquals(List.of(1L, 2L), heard);
    }
}

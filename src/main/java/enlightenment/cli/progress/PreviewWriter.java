package enlightenment.cli.progress;

import enlightenment.cli.terminal.Terminal;
import enlightenment.file.FileFailure;
import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.work.ThreadEnd;
import java.io.IOException;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Writes the picture so far now and then, on a thread of its own, so that no rendering thread waits for the disk; passes
 * everything on to the display.
 */
public final class PreviewWriter implements RenderProgress {
    private static final double NANO = 1e-9;

    /** The largest share of the time that writing may take: large pictures are written less often. */
    private static final double SHARE = 0.05;

    /** Writes a picture to the disk. */
    @FunctionalInterface
    public interface Writer {
        void write(Image image) throws IOException;
    }

    private final RenderProgress display;
    private final double period;
    private final Writer writer;
    private final Terminal terminal;
    private final LongSupplier clock;
    private long last;
    private volatile long took;
    private volatile boolean failed;
    private Thread writing;

    /**
     * @param display everything is passed on to it
     * @param period least number of seconds between two writes
     * @param clock nanoseconds
     */
    public PreviewWriter(RenderProgress display, double period, Writer writer, Terminal terminal, LongSupplier clock) {
        this.display = display;
        this.period = period;
        this.writer = writer;
        this.terminal = terminal;
        this.clock = clock;
        last = clock.getAsLong();
    }

    @Override
    public void planned(double samples, String decidedBy) {
        display.planned(samples, decidedBy);
    }

    @Override
    public void note(String text) {
        display.note(text);
    }

    @Override
    public void progress(long done, long total, Supplier<Image> soFar) {
        display.progress(done, total, soFar);
        long now = clock.getAsLong();
        boolean due = (now - last) * NANO >= Math.max(period, took * NANO / SHARE);
        boolean busy = writing != null && writing.isAlive();
        // The command writes the finished picture itself.
        if (!due || busy || failed || done == total) {
            return;
        }
        last = now;
        Image image = soFar.get();
        writing = new Thread(() -> write(image), "preview");
        writing.setDaemon(true);
        writing.start();
    }

    private void write(Image image) {
        long start = clock.getAsLong();
        try {
            writer.write(image);
        } catch (IOException e) {
            failed = true;
            terminal.say("no more previews: " + FileFailure.described(e));
        }
        took = clock.getAsLong() - start;
    }

    /** Returns when nothing is being written any more. */
    public void finish() {
        if (writing != null) {
            ThreadEnd.await(writing);
        }
    }
}

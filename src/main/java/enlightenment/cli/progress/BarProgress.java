package enlightenment.cli.progress;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.status.TimeLeft;
import java.io.PrintStream;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** Progress as a bar with the time that remains. Nothing else refers to the library that draws it. */
public final class BarProgress implements RenderProgress, AutoCloseable {
    private static final int USUAL_COLUMNS = 80;
    private static final int PERIOD_MILLIS = 250;

    private final PrintStream err;
    private final TimeLeft timeLeft = new TimeLeft();
    private ProgressBar bar;

    BarProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public synchronized void progress(long done, long total, Supplier<Image> soFar) {
        if (bar == null) {
            bar = new ProgressBarBuilder()
                    .setTaskName("render")
                    .setInitialMax(total)
                    .setStyle(ProgressBarStyle.ASCII)
                    .setUpdateIntervalMillis(PERIOD_MILLIS)
                    .setEtaFunction(state -> estimate())
                    // With a width of our own, the library need not load native code to ask the terminal for it.
                    .setConsumer(new ConsoleProgressBarConsumer(err, columns()))
                    .build();
        }
        timeLeft.at(System.nanoTime(), done, total);
        bar.stepTo(done);
    }

    /** Without an estimate the bar shows a question mark. */
    private Optional<Duration> estimate() {
        OptionalDouble left = timeLeft.seconds();
        return left.isPresent()
                ? Optional.of(Duration.ofSeconds((long) Math.ceil(left.getAsDouble())))
                : Optional.empty();
    }

    /** The largest width of a bar in columns. */
    public static int columns() {
        String columns = System.getenv("COLUMNS");
        try {
            return columns == null ? USUAL_COLUMNS - 1 : Math.max(Integer.parseInt(columns) - 1, USUAL_COLUMNS / 2);
        } catch (NumberFormatException e) {
            return USUAL_COLUMNS - 1;
        }
    }

    /** Draws the bar a last time and ends its line. */
    @Override
    public synchronized void close() {
        if (bar != null) {
            bar.close();
        }
    }
}

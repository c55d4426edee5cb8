package enlightenment.cli.measure;

import enlightenment.cli.progress.BarProgress;
import java.io.PrintStream;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** A bar with the time that remains and what is being done. */
final class TradeBar implements AutoCloseable {
    private static final int PERIOD_MILLIS = 250;

    private final ProgressBar bar;

    TradeBar(PrintStream err) {
        bar = new ProgressBarBuilder()
                .setTaskName("trade")
                .setInitialMax(1)
                .setStyle(ProgressBarStyle.ASCII)
                .setUnit(" s", 1000)
                .setUpdateIntervalMillis(PERIOD_MILLIS)
                .setConsumer(new ConsoleProgressBarConsumer(err, BarProgress.columns()))
                .build();
    }

    /** Times in milliseconds. */
    void show(String what, long done, long total) {
        bar.maxHint(total);
        bar.stepTo(done);
        bar.setExtraMessage(" " + what);
    }

    @Override
    public void close() {
        bar.close();
    }
}

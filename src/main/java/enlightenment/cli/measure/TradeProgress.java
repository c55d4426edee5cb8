package enlightenment.cli.measure;

import enlightenment.cli.progress.ProgressKind;
import enlightenment.measure.trade.TradeListener;
import java.io.PrintStream;

/** Progress of a trade, measured in time, as its budget is. */
final class TradeProgress implements TradeListener, AutoCloseable {
    private static final long PERIOD_NANOS = 2_000_000_000L;
    private static final double MILLI = 1000;

    private final PrintStream err;
    private final boolean plain;
    private final TradeBar bar;
    private String what = "";
    private long last;

    private TradeProgress(PrintStream err, boolean plain, TradeBar bar) {
        this.err = err;
        this.plain = plain;
        this.bar = bar;
    }

    /** @param kind any but {@link ProgressKind#AUTO} */
    static TradeProgress of(ProgressKind kind, PrintStream err) {
        return new TradeProgress(err, kind == ProgressKind.PLAIN, kind == ProgressKind.BAR ? new TradeBar(err) : null);
    }

    @Override
    public synchronized void progress(String now, double done, double total) {
        if (bar != null) {
            bar.show(now, (long) (done * MILLI), (long) (total * MILLI));
        } else if (plain && (!now.equals(what) || System.nanoTime() - last > PERIOD_NANOS)) {
            last = System.nanoTime();
            long left = (long) Math.ceil(total - done);
            err.println((int) (100 * done / total) + " % of the time, " + left + " s left: " + now);
        }
        what = now;
    }

    @Override
    public void close() {
        if (bar != null) {
            bar.close();
        }
    }
}

package enlightenment.listen;

import enlightenment.text.Plain;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * The log of a server: lines of plain text of bounded length. Lines that any host on the network can cause are limited to a few a minute, per address
 * and in all; the number of omitted lines is logged, too.
 */
public final class ServerLog {
    public static final int LONGEST_LINE = 500;
    public static final int LINES_ABOUT_ONE = 6;
    static final int LINES_ABOUT_ALL = 30;
    static final long WINDOW_NANOS = 60_000_000_000L;

    private final Consumer<String> lines;
    private final LongSupplier clock;
    private final Map<String, Integer> told = new HashMap<>();
    private long windowBegan;
    private int toldOfAll;
    private long leftOut;

    public ServerLog(Consumer<String> lines, LongSupplier clock) {
        this.lines = lines;
        this.clock = clock;
        windowBegan = clock.getAsLong();
    }

    /** Logs a line that the operator or an authenticated worker has caused. */
    public void say(String text) {
        lines.accept(Plain.line(text, LONGEST_LINE));
    }

    /** Logs a line that an unauthenticated connection or a shortage has caused, unless the limit is reached. */
    public void seldom(String about, String text) {
        tick();
        synchronized (this) {
            // The map is bounded: it has at most one address for each line.
            int before = told.getOrDefault(about, 0);
            if (before == LINES_ABOUT_ONE || toldOfAll == LINES_ABOUT_ALL) {
                leftOut++;
                return;
            }
            told.put(about, before + 1);
            toldOfAll++;
        }
        say(text);
    }

    /** Begins a new minute, if the last one is over; to be called regularly. */
    public void tick() {
        long missing;
        synchronized (this) {
            if (clock.getAsLong() - windowBegan < WINDOW_NANOS) {
                return;
            }
            windowBegan = clock.getAsLong();
            told.clear();
            toldOfAll = 0;
            missing = leftOut;
            leftOut = 0;
        }
        if (missing > 0) {
            say("in the last minute " + missing + " more lines about connections of strangers were left out");
        }
    }
}

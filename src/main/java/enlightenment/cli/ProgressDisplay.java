package enlightenment.cli;

import enlightenment.render.RenderProgress;
import java.io.Console;
import java.io.PrintStream;
import java.util.function.LongSupplier;

/** Chooses how progress is shown. */
final class ProgressDisplay {
    static final String[] KINDS = {"auto", "bar", "plain", "none"};

    private ProgressDisplay() {}

    /** The display of one of {@link #KINDS}. */
    static RenderProgress of(String kind, PrintStream err) {
        return switch (chosen(kind)) {
            case "none" -> RenderProgress.NONE;
            case "bar" -> new BarProgress(err);
            default -> new PlainProgress(err, new NanoClock());
        };
    }

    /** The kind that {@code auto} stands for here, or the kind itself. */
    static String chosen(String kind) {
        if (!kind.equals("auto")) {
            return kind;
        }
        return isInteractive() ? "bar" : "plain";
    }

    /** Ends the display. */
    static void end(RenderProgress display) {
        if (display instanceof BarProgress bar) {
            bar.close();
        }
    }

    private static boolean isInteractive() {
        Console console = System.console();
        if (console == null) {
            return false;
        }
        try {
            // From Java 22 on there is a console even where there is no terminal; this method came with it.
            return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
        } catch (ReflectiveOperationException e) {
            return true;
        }
    }

    /** A class rather than a lambda: one of those costs more at start-up than a whole small tile. */
    private static final class NanoClock implements LongSupplier {
        @Override
        public long getAsLong() {
            return System.nanoTime();
        }
    }
}

package enlightenment.cli.progress;

import enlightenment.cli.terminal.StandardStreams;
import enlightenment.cli.terminal.Terminal;
import enlightenment.render.RenderProgress;
import java.io.Console;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.function.LongSupplier;
import picocli.CommandLine.Option;

/** The option that says how progress is shown. */
public final class ProgressOption {
    @Option(
            names = "--progress",
            paramLabel = "DISPLAY",
            converter = ProgressKind.Words.class,
            completionCandidates = ProgressKind.Words.class,
            description = "how progress is shown: auto (default), bar, plain or none")
    private ProgressKind kind = ProgressKind.AUTO;

    public ProgressOption() {}

    /** The chosen kind; for {@code auto} the one that it stands for here. */
    public ProgressKind kind() {
        if (kind != ProgressKind.AUTO) {
            return kind;
        }
        return isInteractive() ? ProgressKind.BAR : ProgressKind.PLAIN;
    }

    /** A display of a render's progress. */
    public RenderProgress display(PrintStream err) {
        return switch (kind()) {
            case NONE -> RenderProgress.NONE;
            case BAR -> new BarProgress(err);
            default -> new PlainProgress(err, new NanoClock());
        };
    }

    /** Reports a written file, terminal or not; silent with {@code none}, and where the picture is standard output. */
    public void tellWritten(Path file, Terminal terminal) {
        if (kind != ProgressKind.NONE && !StandardStreams.isNamed(file)) {
            terminal.say("wrote " + file);
        }
    }

    /** Ends a display. */
    public static void end(RenderProgress display) {
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

    /** A class rather than a lambda: the first lambda costs more at start-up than a small tile takes to render. */
    private static final class NanoClock implements LongSupplier {
        @Override
        public long getAsLong() {
            return System.nanoTime();
        }
    }
}

package enlightenment.cli.terminal;

import enlightenment.text.Plain;
import java.io.InputStream;
import java.io.PrintStream;
import java.util.regex.Pattern;

/**
 * The streams of a command, and the signal that can stop it.
 *
 * @param in the stream that {@code -} means as an input
 * @param out results; the stream that {@code -} means as an output
 * @param err messages and progress
 * @param stop is requested when the user wants a render to end
 */
public record Terminal(InputStream in, PrintStream out, PrintStream err, ShutdownSignal stop) {
    private static final Pattern FOREIGN_LINE = Pattern.compile("\n(?!  )");

    /** Without input. */
    public Terminal(PrintStream out, PrintStream err, ShutdownSignal stop) {
        this(InputStream.nullInputStream(), out, err, stop);
    }

    /**
     * One message for the user; parts of it may come from elsewhere. Lines that it goes on with are indented: no other line end in it
     * is ours.
     */
    public void say(String message) {
        note("enlightenment: " + FOREIGN_LINE.matcher(message).replaceAll("?"));
    }

    /** Lines for the user that say themselves what they are about. */
    public void note(String lines) {
        err.println(Plain.lines(lines));
    }

    /** Lines of a result that may hold texts of scenes. */
    public void show(String lines) {
        out.println(Plain.lines(lines));
    }
}

package enlightenment.cli;

import java.io.PrintStream;

/** Runs several commands, a bar between them, in a process that has a locale of its own. */
public final class LocaleProbe {
    private LocaleProbe() {}

    /** Writes what each says to standard output, then its exit code. */
    public static void main(String[] args) {
        PrintStream out = System.out;
        for (String command : String.join("\t", args).split("\t\\|\t")) {
            int code = Main.run(CliRun.quiet(command.split("\t", -1)), out, out);
            out.println(code);
        }
        out.flush();
    }
}

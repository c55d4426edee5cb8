package enlightenment.cli;

import enlightenment.cli.input.Failures;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import enlightenment.cli.terminal.Version;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.Set;
import picocli.CommandLine;

/** The entry point of the command line. */
public final class Main {
    /** Commands that end well when they are asked to end. */
    private static final Set<String> STOPPABLE = Set.of("render", "animate", "trade", "bench", "server", "worker");

    private Main() {}

    /**
     * Does what the arguments say and ends the process: 0 done, 1 failed, 2 wrong usage or a scene that cannot be used; 128 and
     * its number after a signal.
     */
    public static void main(String[] args) {
        ShutdownSignal stop = new ShutdownSignal(
                () -> System.err.println("enlightenment: stopped in the middle: nothing was written"));
        if (args.length > 0 && STOPPABLE.contains(args[0])) {
            stop.listen();
        }
        int code;
        try {
            code = run(args, new Terminal(System.in, System.out, System.err, stop));
        } finally {
            // Only now has everything been said.
            stop.finished();
        }
        if (!stop.processIsEnding()) {
            System.exit(code);
        }
    }

    /** Does what the arguments say, within this process; gives the exit code. */
    static int run(String[] args, PrintStream out, PrintStream err) {
        return run(args, new Terminal(out, err, new ShutdownSignal()));
    }

    static int run(String[] args, Terminal terminal) {
        int code;
        try {
            code = dispatch(args, terminal);
        } catch (Throwable t) {
            // Errors such as a lack of memory, which picocli lets pass.
            code = new Failures(terminal).report(t);
        }
        if (terminal.out().checkError()) {
            terminal.say("cannot write to standard output");
            return Math.max(code, ExitCode.FAILED);
        }
        return code;
    }

    /** Gives picocli no more than the chosen command: reading the annotations of all of them takes longer than some renders. */
    private static int dispatch(String[] args, Terminal terminal) {
        if (args.length == 1 && (args[0].equals("--version") || args[0].equals("-V"))) {
            terminal.out().println(Version.line());
            return ExitCode.DONE;
        }
        Subcommand command = args.length == 0 ? null : Commands.create(args[0], terminal);
        if (command == null) {
            return Commands.executeTree(args, terminal);
        }
        String[] arguments = Arrays.copyOfRange(args, 1, args.length);
        CommandLine line = Commands.configure(Commands.line(command, arguments), terminal);
        line.setCommandName("enlightenment " + args[0]);
        return line.execute(arguments);
    }
}

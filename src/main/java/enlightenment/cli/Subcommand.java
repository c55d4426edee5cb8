package enlightenment.cli;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Option;

/** What all commands have in common. */
abstract class Subcommand implements Callable<Integer> {
    final Terminal terminal;

    // Read by picocli only: it prints the help.
    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "show this help")
    private boolean help;

    Subcommand(Terminal terminal) {
        this.terminal = terminal;
    }

    /** The options for settings of methods, if this command has them. */
    Optional<MethodOptions> methodOptions() {
        return Optional.empty();
    }

    @Override
    public final Integer call() throws IOException {
        return execute();
    }

    /**
     * Does what the command is for; {@link Failures} tells what is thrown.
     *
     * @return one of {@link ExitCode}
     */
    abstract int execute() throws IOException;
}

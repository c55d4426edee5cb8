package enlightenment.cli;

import java.io.IOException;
import picocli.CommandLine.Option;

/** What all commands have in common. */
abstract class Subcommand {
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

    /**
     * Does it.
     *
     * @return the exit code
     */
    abstract int execute() throws IOException;

    /** Whether only help is wanted. */
    final boolean wantsHelp() {
        return help;
    }
}

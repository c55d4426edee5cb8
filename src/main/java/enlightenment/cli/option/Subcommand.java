package enlightenment.cli.option;

import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The base of all commands. */
public abstract class Subcommand implements Callable<Integer> {
    protected final Terminal terminal;

    // Read by picocli only: it prints the help.
    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "show this help")
    private boolean help;

    /** Picocli's model of the command, which has the options that were given. */
    @Spec
    private CommandSpec command;

    protected Subcommand(Terminal terminal) {
        this.terminal = terminal;
    }

    /** The options for settings of methods, if this command has them. */
    public Optional<MethodOptions> methodOptions() {
        return Optional.empty();
    }

    /** Which of its options exclude or need others. */
    public List<OptionRule> rules() {
        return List.of();
    }

    @Override
    public final Integer call() throws IOException {
        Set<String> given = given();
        for (OptionRule rule : rules()) {
            rule.broken(given).ifPresent(told -> {
                throw CliException.wrongUsage(told);
            });
        }
        return execute();
    }

    /** The longest names of the options that were given; a flag that was switched off ({@code --stats=false}) is not. */
    private Set<String> given() {
        Set<String> given = new HashSet<>();
        for (OptionSpec option : command.commandLine().getParseResult().matchedOptions()) {
            if (!Boolean.FALSE.equals(option.getValue())) {
                given.add(option.longestName());
            }
        }
        return given;
    }

    /**
     * Does what the command is for; {@code Failures} tells what is thrown.
     *
     * @return one of {@link ExitCode}
     */
    protected abstract int execute() throws IOException;
}

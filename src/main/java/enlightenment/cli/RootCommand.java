package enlightenment.cli;

import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Version;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The root of the command tree; it does nothing itself. */
@Command(
        name = "enlightenment",
        description = "Makes pictures of scenes.",
        versionProvider = Version.class,
        synopsisSubcommandLabel = "COMMAND",
        footer = {
            "",
            "Exit codes: 0 done, 1 failed, 2 wrong usage, or a scene or picture that cannot be used.",
            "'enlightenment help COMMAND' shows the options of a command."
        })
final class RootCommand implements Callable<Integer> {
    // Both are read by picocli only.
    @Option(
            names = {"-h", "--help"},
            usageHelp = true,
            description = "show this help")
    private boolean help;

    @Option(
            names = {"-V", "--version"},
            versionHelp = true,
            description = "show the version of Enlightenment and of Java")
    private boolean version;

    @Spec
    private CommandSpec spec;

    RootCommand() {}

    /** Called where no command is given: shows the help, which is no success. */
    @Override
    public Integer call() {
        spec.commandLine().usage(spec.commandLine().getErr());
        return ExitCode.WRONG_INPUT;
    }
}

package enlightenment.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** What stands above all commands; it does nothing itself. */
@Command(
        name = "enlightenment",
        description = "Makes pictures of scenes.",
        synopsisSubcommandLabel = "COMMAND",
        footer = {
            "",
            "Exit codes: 0 done, 1 failed, 2 wrong usage, or a scene or picture that cannot be used.",
            "'enlightenment help COMMAND' tells more about a command."
        })
final class RootCommand implements Runnable {
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

    RootCommand() {}

    /** Never called without a command: {@link Commands#executeTree} refuses that before. */
    @Override
    public void run() {}
}

package enlightenment.cli;

import enlightenment.net.FilmServer;
import enlightenment.net.ServerOptions;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;

/** The options that have a film made with the help of workers. */
final class FilmServing {
    @Option(
            names = "--server",
            description =
                    "render with the help of workers, as the command server does; the options from here on are for that")
    private boolean server;

    @Mixin
    private ServingOptions serving = new ServingOptions();

    FilmServing() {}

    boolean isAsked() {
        return server;
    }

    /** Fails if options do not go together. */
    void check(CommandSpec command, RenderOptions render, FrameOutput output) {
        Set<String> ours = CommandSpec.forAnnotatedObject(new ServingOptions())
                .optionsMap()
                .keySet();
        List<String> given = command.commandLine().getParseResult().matchedOptions().stream()
                .map(OptionSpec::longestName)
                .filter(ours::contains)
                .toList();
        if (!server && !given.isEmpty()) {
            throw CliException.wrongUsage(given.get(0) + " is for --server, which is not given");
        }
        if (server && render.hasTime()) {
            throw CliException.wrongUsage(
                    "--time must not be given with --server, where no frame has a time of its own:"
                            + " give --samples or --error");
        }
        if (server && !output.aov().kinds().isEmpty()) {
            throw CliException.wrongUsage("--aov must not be given with --server: workers send colours only");
        }
    }

    /** What the options ask for; null without {@code --server}. */
    ServerOptions options(Terminal terminal) throws IOException {
        return server ? serving.options(terminal).build() : null;
    }

    /** Says which files the server reads and writes. */
    void register(CommandFiles files) {
        if (server) {
            serving.register(files);
        }
    }

    /** Tells where the server is. */
    void announce(FilmServer started, Terminal terminal) throws IOException {
        serving.announce(started.port(), started.pin(), started.statusPort(), terminal);
    }
}

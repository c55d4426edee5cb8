package enlightenment.cli.render;

import enlightenment.cli.option.CommandFiles;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.picture.ResultPicture;
import enlightenment.cli.terminal.CliException;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.net.parts.RenderParts;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment merge}: makes a picture of the parts of a render. */
@Command(name = "merge", description = "Makes a picture of the parts of a render.", sortOptions = false)
public final class MergeCommand extends Subcommand {
    private static final int MAX_NAMED = 20;

    @Parameters(arity = "1..*", paramLabel = "PART", description = "files of 'render --part'")
    private List<Path> parts;

    @Mixin
    private ResultPicture output = new ResultPicture();

    @Option(names = "--partial", description = "write the picture even if parts are missing; they are black")
    private boolean partial;

    public MergeCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    protected int execute() throws IOException {
        CommandFiles files = new CommandFiles();
        parts.forEach(part -> files.reads("a part", part));
        output.check(files);
        RenderParts.Merged merged = RenderParts.merge(parts, output.scratch());
        String missing = merged.missing().isEmpty() ? "" : inWords(merged.missing());
        if (!missing.isEmpty() && !partial) {
            terminal.say(missing);
            throw CliException.failed(output.name() + " was not written; --partial writes what there is");
        }
        output.write(merged.result(), merged.text(), missing, terminal);
        return ExitCode.DONE;
    }

    private static String inWords(List<String> missing) {
        String named = String.join(", ", missing.subList(0, Math.min(missing.size(), MAX_NAMED)));
        int more = missing.size() - MAX_NAMED;
        return "missing: " + named + (more > 0 ? " and " + more + " more" : "");
    }
}

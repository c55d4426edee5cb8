package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.PngOptions;
import enlightenment.net.RenderParts;
import enlightenment.picture.Rounding;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment merge}: makes a picture of the parts of a render. */
@Command(name = "merge", description = "Makes a picture of the parts of a render.", sortOptions = false)
final class MergeCommand extends Subcommand {
    private static final int MAX_NAMED = 20;

    @Parameters(arity = "1..*", paramLabel = "PART", description = "files of 'render --part'")
    private List<Path> parts;

    @Mixin
    private PictureOutput output = new PictureOutput();

    @Mixin
    private ViewOption view = new ViewOption();

    @Mixin
    private ReportOutput report = new ReportOutput();

    @Option(names = "--partial", description = "write the picture even if parts are missing; they are black")
    private boolean partial;

    MergeCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        output.check();
        view.check(output);
        CommandFiles files = new CommandFiles();
        parts.forEach(part -> files.reads("a part", part));
        files.writes("-o", output.file());
        report.register(files);
        files.check();
        RenderParts.Merged merged = RenderParts.merge(parts);
        boolean isWhole = merged.missing().isEmpty();
        if (!isWhole && !partial) {
            terminal.say(inWords(merged.missing()));
            throw CliException.failed(output.name() + " was not written; --partial writes what there is");
        }
        RenderResult result = merged.result();
        result = result.withRounding(Rounding.of(result.image(), output.writtenDepth()));
        Image shown = view.view(result.image(), terminal);
        output.write(shown, new PngOptions(output.depth(), merged.text()), terminal);
        report.write(result, output, terminal);
        if (!isWhole) {
            throw CliException.failed(inWords(merged.missing()));
        }
        LightNotes.tell(result, shown, terminal::say);
        LightNotes.require(result);
        RequestedError.require(result);
        return ExitCode.DONE;
    }

    private static String inWords(List<String> missing) {
        String named = String.join(", ", missing.subList(0, Math.min(missing.size(), MAX_NAMED)));
        int more = missing.size() - MAX_NAMED;
        return "missing: " + named + (more > 0 ? " and " + more + " more" : "");
    }
}

package enlightenment.cli;

import enlightenment.image.PngOptions;
import enlightenment.net.RenderParts;
import enlightenment.picture.Rounding;
import enlightenment.render.RenderResult;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code enlightenment merge}: makes a picture of the parts of a render. */
@Command(name = "merge", description = "Makes a picture of the parts of a render.", sortOptions = false)
final class MergeCommand extends Subcommand {
    /** More than this many missing parts are not worth naming. */
    private static final int MOST_NAMED = 20;

    @Parameters(arity = "1..*", paramLabel = "PART", description = "files of 'render --part'")
    private List<Path> parts;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "FILE",
            description = "the picture: .png, or .pfm for exact floats; - for standard output")
    private Path output;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            description = "with -o -: png (default) or pfm, to standard output")
    private String format;

    @Option(names = "--depth", paramLabel = "BITS", description = "bits per component of a PNG file: 8 (default) or 16")
    private String depth;

    @Option(names = "--report", paramLabel = "FILE", description = "write what was done to this JSON file")
    private Path report;

    @Option(names = "--stats", description = "show what was done")
    private boolean stats;

    @Option(names = "--partial", description = "write the picture even if parts are missing; they are black")
    private boolean partial;

    MergeCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    int execute() throws IOException {
        PictureOptions.check(output, depth, format);
        OutputFiles files = new OutputFiles();
        parts.forEach(part -> files.reads("a part", part));
        files.writes("-o", output).writes("--report", report).check();
        RenderParts.Merged merged = RenderParts.merge(parts);
        RenderResult result = merged.result()
                .withRounding(Rounding.of(merged.result().image(), PictureOptions.depth(output, format, depth)));
        if (!merged.missing().isEmpty() && !partial) {
            say(merged.missing());
            terminal.say(Standard.output(output) + " was not written; --partial writes what there is");
            return CliException.FAILED;
        }
        int bits = "16".equals(depth) ? 16 : 8;
        PngOptions png = new PngOptions(bits, merged.text());
        PictureOptions.write(result.image(), output, format, png, terminal);
        if (report != null) {
            OutputFile.write(report, ReportJson.of(result));
        }
        if (stats) {
            PictureOptions.printStatistics(result.report(), output, terminal);
        }
        say(merged.missing());
        boolean isWhole = merged.missing().isEmpty();
        return isWhole && PictureOptions.keepsError(result.report(), terminal)
                ? CliException.DONE
                : CliException.FAILED;
    }

    private void say(List<String> missing) {
        if (!missing.isEmpty()) {
            String some = String.join(", ", missing.subList(0, Math.min(missing.size(), MOST_NAMED)));
            int more = missing.size() - MOST_NAMED;
            terminal.say("missing: " + some + (more > 0 ? " and " + more + " more" : ""));
        }
    }
}
